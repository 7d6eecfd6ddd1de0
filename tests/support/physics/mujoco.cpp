// Models from text through MuJoCo's file system in memory: it reads them from files only.
#include "physics/mujoco.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace foothold::physics {

OwnedModel compiled(const std::string& xml) {
  struct FileSystem {
    FileSystem() : files(std::make_unique<mjVFS>()) { mj_defaultVFS(files.get()); }
    ~FileSystem() { mj_deleteVFS(files.get()); }
    std::unique_ptr<mjVFS> files;
  } system;
  mjVFS& files = *system.files;
  if (mj_makeEmptyFileVFS(&files, "model.xml", static_cast<int>(xml.size())) != 0)
    throw std::runtime_error("MuJoCo has no room for a model of " + std::to_string(xml.size()) + " octets");
  std::copy(xml.begin(), xml.end(), static_cast<char*>(files.filedata[0]));
  char error[500] = "";
  OwnedModel model(mj_loadXML("model.xml", &files, error, sizeof error));
  if (!model) throw std::runtime_error(std::string("MuJoCo refuses a model: ") + error);
  return model;
}

OwnedData state_of(const mjModel& model) {
  OwnedData data(mj_makeData(&model));
  if (!data) throw std::runtime_error("MuJoCo has no memory for a model's state");
  return data;
}

std::string words(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out.precision(17);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

}  // namespace foothold::physics
