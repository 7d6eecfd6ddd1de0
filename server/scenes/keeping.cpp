// From a temporary file to a stored scene.
#include "scenes/keeping.hpp"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

// Hears the file and keeps nothing: for the syntax alone.
class Deaf final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (number_ < 0) throw std::system_error(errno, std::generic_category(), path);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void sync() const {
    if (::fsync(number_) != 0) throw std::system_error(errno, std::generic_category(), "fsync");
  }

 private:
  int number_;
};

}  // namespace

std::string file_sha256(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::system_error(errno, std::generic_category(), file);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr);
  std::vector<char> block(1u << 20);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0)
    EVP_DigestUpdate(context.get(), block.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw std::system_error(errno, std::generic_category(), file);
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned length = 0;
  EVP_DigestFinal_ex(context.get(), digest, &length);
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    text += "0123456789abcdef"[digest[i] >> 4];
    text += "0123456789abcdef"[digest[i] & 15];
  }
  return text;
}

std::optional<msg::Error> check_yaml(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  try {
    YAML::Parser parser(in);
    Deaf deaf;
    if (!parser.HandleNextDocument(deaf)) return msg::make_error(msg::INVALID_SCENE, "line 1: the file is empty", "line 1");
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    const std::string line = "line " + std::to_string(error.mark.line + 1);
    return msg::make_error(msg::INVALID_SCENE, line + ": is not YAML: " + error.msg, line);
  }
}

std::optional<msg::Error> keep_scene(const std::string& file, const std::string& revision, const std::string& format,
                                     const std::string& place) {
  std::error_code ignored;
  const auto drop = [&](msg::Error error) {
    fs::remove(file, ignored);
    return error;
  };
  try {
    if (const std::string found = file_sha256(file); found != revision)
      return drop(refuse(msg::SCENE_HASH_MISMATCH, "revision", "is " + revision + ", but what arrived has " + found));
    if (format == "yaml") {
      if (const auto size = fs::file_size(file); size > kMostYamlOctets)
        return drop(refuse(msg::SCENE_TOO_LARGE, "size",
                           "must be " + std::to_string(kMostYamlOctets) + " octets at most for yaml, is " + std::to_string(size)));
      if (auto error = check_yaml(file)) return drop(std::move(*error));
    }
    if (fs::exists(place)) {
      fs::remove(file);
      return std::nullopt;
    }
    Descriptor(file, O_RDONLY).sync();
    fs::rename(file, place);
    Descriptor(fs::path(place).parent_path().string(), O_RDONLY | O_DIRECTORY).sync();
    return std::nullopt;
  } catch (const std::system_error& error) {
    return drop(msg::make_error(msg::STORAGE_FAILED, std::string("the scene could not be stored: ") + error.what()));
  }
}

}  // namespace foothold::server
