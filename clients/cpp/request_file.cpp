// Requests as YAML files.
#include "foothold/client/request_file.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "foothold/client/whole_file.hpp"
#include "yaml_field.hpp"

namespace foothold::client {
namespace {

constexpr double kUnit = 1e-6;  // how far a quaternion's length may be from 1: the protocol's bound

// Half angle, so that a whole turn's quarters come out exactly as cos and sin give them.
double half(double degrees) { return degrees * std::numbers::pi / 360.0; }

msg::Quaternion quaternion(double w, double x, double y, double z) {
  msg::Quaternion q;
  q.w(w);
  q.x(x);
  q.y(y);
  q.z(z);
  return q;
}

// Turns about the fixed x, then y, then z axis: R = Rz(yaw) Ry(pitch) Rx(roll).
msg::Quaternion from_rpy(double roll, double pitch, double yaw) {
  const double cr = std::cos(half(roll)), sr = std::sin(half(roll));
  const double cp = std::cos(half(pitch)), sp = std::sin(half(pitch));
  const double cy = std::cos(half(yaw)), sy = std::sin(half(yaw));
  return quaternion(cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
                    cr * cp * sy - sr * sp * cy);
}

std::vector<double> exactly(const YamlField& field, std::size_t count, const char* what) {
  std::vector<double> values = field.numbers();
  if (values.size() != count) field.refuse("expected " + std::string(what) + ", not " + std::to_string(values.size()) + " numbers");
  return values;
}

msg::Quaternion read_orientation(const YamlField& frame, bool needed) {
  const auto orientation = frame.find("orientation"), rpy = frame.find("rpy_deg"), heading = frame.find("heading_deg");
  const int given = int(orientation.has_value()) + int(rpy.has_value()) + int(heading.has_value());
  if (given > 1) frame.refuse("orientation, rpy_deg and heading_deg exclude each other");
  if (given == 0 && needed)
    frame.refuse("orientation is missing: give orientation [w, x, y, z], rpy_deg [roll, pitch, yaw] or heading_deg");
  if (orientation) {
    const auto q = exactly(*orientation, 4, "[w, x, y, z]");
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (std::abs(length - 1.0) > kUnit)
      orientation->refuse("a quaternion of length " + std::to_string(length) + ", not 1: give more digits, or rpy_deg");
    return quaternion(q[0], q[1], q[2], q[3]);
  }
  if (rpy) {
    const auto angles = exactly(*rpy, 3, "[roll, pitch, yaw]");
    return from_rpy(angles[0], angles[1], angles[2]);
  }
  return from_rpy(0.0, 0.0, heading ? heading->number() : 0.0);
}

msg::Pose read_pose(const YamlField& frame, bool orientation_needed) {
  const auto position = exactly(frame.at("position"), 3, "[x, y, z]");
  msg::Pose pose;
  pose.position().x(position[0]);
  pose.position().y(position[1]);
  pose.position().z(position[2]);
  pose.orientation(read_orientation(frame, orientation_needed));
  return pose;
}

msg::Placement read_placement(const YamlField& field) {
  field.expect_mapping({"base", "any_orientation", "contacts", "joints"});
  msg::Placement placement;
  if (const auto any = field.find("any_orientation")) placement.any_orientation(any->flag());
  if (const auto base = field.find("base")) {
    base->expect_mapping({"position", "orientation", "rpy_deg", "heading_deg"});
    placement.base().push_back(read_pose(*base, !placement.any_orientation()));
  } else if (placement.any_orientation()) {
    field.refuse("any_orientation says something about base, which is missing");
  }
  if (const auto joints = field.find("joints")) placement.joints(joints->numbers());
  if (const auto contacts = field.find("contacts"))
    for (const YamlField& item : contacts->items()) {
      item.expect_mapping({"limb", "position", "orientation", "rpy_deg", "heading_deg", "face"});
      msg::Contact contact;
      if (const auto limb = item.find("limb")) contact.limb(limb->text());
      contact.frame(read_pose(item, true));
      if (const auto face = item.find("face")) contact.face(face->text());
      placement.contacts().push_back(contact);
    }
  return placement;
}

void read_scene(const YamlField& field, const std::filesystem::path& beside, RequestFile& out) {
  if (field.is_text()) {
    const std::string name = field.text();
    for (const char* ending : {".yaml", ".yml", ".stl", ".obj", ".ply"})
      if (name.ends_with(ending)) field.refuse("'" + name + "' looks like a file: write scene: {file: " + name + "}");
    out.request.scene(name);
    return;
  }
  field.expect_mapping({"name", "revision", "file"});
  const auto file = field.find("file"), revision = field.find("revision"), name = field.find("name");
  if (file && revision) field.refuse("file and revision exclude each other: a file has the revision that it has");
  if (file) out.scene_file = (beside / file->text()).lexically_normal().string();
  if (revision) out.request.scene_revision(revision->text());
  if (name)
    out.request.scene(name->text());
  else if (file)
    out.request.scene(std::filesystem::path(file->text()).stem().string());
  else
    field.refuse("give a name or a file");
}

}  // namespace

RequestFile read_request(const std::string& text, const std::string& path) {
  YAML::Node document;
  try {
    document = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw RequestFileError(path + ":" + std::to_string(std::max(error.mark.line, 0) + 1) + ": not YAML: " + error.msg);
  }
  const YamlField file(path, "", document);
  if (document.IsNull()) file.refuse("the file is empty");
  file.expect_mapping({"robot", "unit", "scene", "start", "goal", "budget", "priority", "seed", "parameters", "shapes", "resume"});
  RequestFile out;
  msg::PlanRequest& request = out.request;
  request.robot(file.at("robot").text());
  if (const auto goal = file.find("goal")) request.goal(read_placement(*goal));
  if (const auto start = file.find("start")) request.start(read_placement(*start));
  if (const auto unit = file.find("unit")) request.unit(unit->text());
  if (const auto scene = file.find("scene")) read_scene(*scene, std::filesystem::path(path).parent_path(), out);
  if (const auto budget = file.find("budget")) {
    request.budget(budget->number());
    if (request.budget() <= 0.0) budget->refuse("expected seconds above 0");
  }
  if (const auto priority = file.find("priority"))
    request.priority(static_cast<std::int32_t>(
        priority->integer(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max())));
  if (const auto seed = file.find("seed")) request.seed(seed->natural());
  if (const auto parameters = file.find("parameters"))
    for (const auto& [name, value] : parameters->texts()) {
      request.parameters().emplace_back();
      request.parameters().back().name(name);
      request.parameters().back().value(value);
    }
  if (const auto shapes = file.find("shapes")) request.shapes(shapes->flag());
  if (const auto resume = file.find("resume")) request.resume(resume->flag());
  return out;
}

RequestFile read_request_file(const std::string& path) {
  std::string text;
  try {
    text = read_whole_file(path);
  } catch (const std::system_error& error) {
    throw RequestFileError(path + ": cannot be read: " + error.code().message());
  }
  return read_request(text, path);
}

}  // namespace foothold::client
