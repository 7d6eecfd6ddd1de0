// The journal's log.
#include "journal/log.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "jobs/ports.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

// Before each batch. The checksum is for the loss of power, after which a file may hold anything at its end.
struct Header {
  std::uint32_t size;
  std::uint32_t checksum;
};

std::uint32_t checksum(std::span<const std::byte> octets) {
  return static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const unsigned char*>(octets.data()), octets.size()));
}

[[noreturn]] void fail(const std::string& file) { throw JournalError(file + ": " + std::strerror(errno)); }

// The numbers of the segments `<path>.<number>`, in order.
std::vector<std::uint64_t> segments(const fs::path& path) {
  std::vector<std::uint64_t> numbers;
  const std::string prefix = path.filename().string() + ".";
  for (const auto& entry : fs::directory_iterator(path.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const std::string number = name.substr(prefix.size());
    if (number.empty() || number.size() > 18 || number.find_first_not_of("0123456789") != std::string::npos) continue;
    numbers.push_back(std::stoull(number));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

msg::Bytes contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  msg::Bytes octets(in ? static_cast<std::size_t>(in.tellg()) : 0);
  in.seekg(0);
  if (!in.read(reinterpret_cast<char*>(octets.data()), static_cast<std::streamsize>(octets.size()))) fail(file);
  return octets;
}

}  // namespace

void visit_batches(std::span<const std::byte> segment, const std::function<void(std::span<const std::byte>)>& visit) {
  while (segment.size() >= sizeof(Header)) {
    Header header{};
    std::memcpy(&header, segment.data(), sizeof header);
    segment = segment.subspan(sizeof header);
    if (header.size > segment.size() || checksum(segment.first(header.size)) != header.checksum) break;
    visit(segment.first(header.size));
    segment = segment.subspan(header.size);
  }
}

Log::~Log() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Log::replay(const std::function<void(std::span<const std::byte>)>& visit) const {
  for (const std::uint64_t number : segments(path_)) visit_batches(contents(file(number)), visit);
}

void Log::restart() {
  std::uint64_t last = 0;
  for (const std::uint64_t number : segments(path_)) {
    last = number;
    if (::unlink(file(number).c_str()) != 0) fail(file(number));
  }
  open(last + 1);
}

void Log::open(std::uint64_t segment) {
  const int descriptor = ::open(file(segment).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(file(segment));
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = descriptor;
  segment_ = segment;
  size_ = 0;
}

std::uint64_t Log::append(std::span<const std::byte> batch) {
  if (size_ >= kSegmentOctets) open(segment_ + 1);
  const Header header{static_cast<std::uint32_t>(batch.size()), checksum(batch)};
  buffer_.resize(sizeof header + batch.size());
  std::memcpy(buffer_.data(), &header, sizeof header);
  std::memcpy(buffer_.data() + sizeof header, batch.data(), batch.size());
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t wrote = ::pwrite(descriptor_, buffer_.data() + done, buffer_.size() - done, static_cast<off_t>(size_ + done));
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote > 0) {
      done += static_cast<std::size_t>(wrote);
      continue;
    }
    const int error = wrote == 0 ? ENOSPC : errno;
    // The next batch goes to the same place; what is there of this one must not look like one.
    if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) open(segment_ + 1);
    errno = error;
    fail(file(segment_));
  }
  size_ += buffer_.size();
  return segment_;
}

void Log::remove_before(std::uint64_t segment) const {
  std::error_code ignored;
  for (std::uint64_t number = segment; number-- > 1;)
    if (!fs::remove(file(number), ignored)) break;
}

}  // namespace foothold::server
