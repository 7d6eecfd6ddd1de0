// One scene file on its way in.
#include "scenes/upload.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "jobs/admission/admission.hpp"
#include "jobs/admission/limits.hpp"
#include "text/text.hpp"

namespace foothold::server {
namespace {

constexpr std::size_t kChunk = 65536;
constexpr std::array<const char*, 4> kFormats = {"yaml", "stl", "obj", "ply"};

[[noreturn]] void fail(const std::string& file) { throw std::system_error(errno, std::generic_category(), file); }

std::string number(std::uint64_t value) { return std::to_string(value); }

}  // namespace

Upload::Upload(SceneLabel label, std::string file) : label_(std::move(label)), file_(std::move(file)) {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail(file_);
}

Upload::~Upload() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(file_.c_str());
}

void Upload::release() {
  ::close(descriptor_);
  descriptor_ = -1;
}

bool Upload::add(const msg::SceneChunk& chunk) {
  const auto& data = chunk.data();
  for (std::size_t done = 0; done < data.size();) {
    const ssize_t wrote = ::pwrite(descriptor_, data.data() + done, data.size() - done, static_cast<off_t>(chunk.offset() + done));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) fail(file_);
    done += static_cast<std::size_t>(wrote);
  }
  std::uint64_t begin = chunk.offset();
  std::uint64_t end = begin + data.size();
  auto piece = pieces_.upper_bound(begin);
  if (piece != pieces_.begin() && std::prev(piece)->second >= begin) --piece;
  while (piece != pieces_.end() && piece->first <= end) {
    begin = std::min(begin, piece->first);
    end = std::max(end, piece->second);
    piece = pieces_.erase(piece);
  }
  pieces_.emplace(begin, end);
  return pieces_.size() <= kMostGaps;
}

bool Upload::complete() const { return first_missing() == label_.size; }

std::uint64_t Upload::first_missing() const { return pieces_.empty() || pieces_.begin()->first != 0 ? 0 : pieces_.begin()->second; }

std::uint64_t Upload::received() const {
  std::uint64_t sum = 0;
  for (const auto& [begin, end] : pieces_) sum += end - begin;
  return sum;
}

std::optional<msg::Error> check_chunk(const msg::SceneChunk& chunk, std::uint64_t max_bytes, const SceneLabel* label) {
  const auto malformed = [](const std::string& field, const std::string& reason) { return refuse(msg::MALFORMED, field, reason); };
  if (chunk.client() == msg::kNoId) return malformed("client", "must not be all zeros");
  if (chunk.name().empty() || chunk.name().size() > limits::kScene)
    return malformed("name", "must have 1 to " + number(limits::kScene) + " octets, has " + number(chunk.name().size()));
  if (!is_clean_text(chunk.name()))
    return malformed("name", "must be UTF-8 without control characters, is " + quoted(chunk.name()));
  if (std::ranges::find(kFormats, chunk.format()) == kFormats.end())
    return refuse(msg::SCENE_FORMAT, "format", "must be yaml, stl, obj or ply, is " + quoted(chunk.format()));
  if (!is_sha256_hex(chunk.revision()))
    return malformed("revision", "must be 64 lower-case hexadecimal digits, is " + quoted(chunk.revision()));
  if (chunk.size() == 0) return malformed("size", "must be above 0");
  if (chunk.size() > max_bytes)
    return refuse(msg::SCENE_TOO_LARGE, "size", "must be " + number(max_bytes) + " octets at most, is " + number(chunk.size()));
  if (chunk.data().empty() || chunk.data().size() > kChunk)
    return malformed("data", "must have 1 to " + number(kChunk) + " octets, has " + number(chunk.data().size()));
  if (chunk.offset() > chunk.size() || chunk.data().size() > chunk.size() - chunk.offset())
    return malformed("offset", "must leave room for the chunk's " + number(chunk.data().size()) + " octets within " +
                                   number(chunk.size()) + ", is " + number(chunk.offset()));
  if (label == nullptr) return std::nullopt;
  const auto differs = [&](const std::string& field) { return malformed(field, "must be the same in every chunk of an upload"); };
  if (chunk.name() != label->name) return differs("name");
  if (chunk.format() != label->format) return differs("format");
  if (chunk.revision() != label->revision) return differs("revision");
  if (chunk.size() != label->size) return differs("size");
  return std::nullopt;
}

}  // namespace foothold::server
