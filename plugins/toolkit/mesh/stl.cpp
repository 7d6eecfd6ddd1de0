// STL: three corners of each triangle, as text or as octets (little endian).
#include <cstring>

#include "foothold/errors.hpp"
#include "mesh/formats.hpp"
#include "mesh/words.hpp"

namespace foothold::mesh {
namespace {

constexpr std::size_t kHeader = 80, kHead = kHeader + sizeof(std::uint32_t);  // octets
constexpr std::size_t kNormal = 12, kTriangle = 50;                           // octets

void add_triangle(Faces& faces, const std::array<Vector3d, 3>& corners) {
  for (const Vector3d& corner : corners) {
    faces.corners.push_back(static_cast<std::int64_t>(faces.vertices.size()));
    faces.vertices.push_back(corner);
  }
  faces.ends.push_back(faces.corners.size());
}

std::uint32_t promised(std::string_view octets) {
  std::uint32_t count = 0;
  std::memcpy(&count, octets.data() + kHeader, sizeof count);
  return count;
}

Faces read_octets(std::string_view octets) {
  Faces faces;
  for (octets.remove_prefix(kHead); !octets.empty(); octets.remove_prefix(kTriangle)) {
    std::array<float, 9> at;
    std::memcpy(at.data(), octets.data() + kNormal, sizeof at);
    add_triangle(faces, {Vector3d(at[0], at[1], at[2]), Vector3d(at[3], at[4], at[5]), Vector3d(at[6], at[7], at[8])});
  }
  return faces;
}

// Of an English word, as some programs write it.
bool is(std::string_view word, std::string_view lower_case) {
  if (word.size() != lower_case.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k)
    if ((word[k] >= 'A' && word[k] <= 'Z' ? word[k] - 'A' + 'a' : word[k]) != lower_case[k]) return false;
  return true;
}

void expect(Words& words, std::string_view wanted) {
  const std::string_view word = words.next();
  if (is(word, wanted)) return;
  words.fail(word.empty() ? "the mesh ends early, " + shown(wanted) + " is missing"
                          : shown(wanted) + " is missing, there is " + shown(word));
}

Faces read_text(std::string_view text) {
  Faces faces;
  Words words(text);
  for (bool inside = false;;) {
    const std::string_view word = words.next();
    if (word.empty()) {
      if (inside) words.fail("the mesh ends early, 'endsolid' is missing");
      return faces;
    }
    if (is(word, inside ? "endsolid" : "solid")) {
      inside = !inside;
      words.skip_line();  // its name
      continue;
    }
    if (!inside || !is(word, "facet")) words.fail(shown(word) + " is not " + (inside ? "'facet' or 'endsolid'" : "'solid'"));
    expect(words, "normal");
    for (int k = 0; k < 3; ++k) words.next();  // some programs write what is no number; the corners say it
    expect(words, "outer");
    expect(words, "loop");
    std::array<Vector3d, 3> corners;
    for (Vector3d& corner : corners) {
      expect(words, "vertex");
      for (double& x : corner) x = words.number(words.next());
    }
    add_triangle(faces, corners);
    expect(words, "endloop");
    expect(words, "endfacet");
  }
}

}  // namespace

Faces read_stl(std::string_view octets) {
  const bool has_head = octets.size() >= kHead;
  if (has_head && octets.size() == kHead + kTriangle * std::size_t{promised(octets)}) return read_octets(octets);
  if (is(Words(octets).next(), "solid")) return read_text(octets);
  if (!has_head) throw InvalidScene("", "the mesh is no STL: neither 'solid' nor 84 octets of a head");
  throw InvalidScene("", "the mesh promises " + std::to_string(promised(octets)) + " triangles, which take " +
                             std::to_string(kHead + kTriangle * std::size_t{promised(octets)}) + " octets, and has " +
                             std::to_string(octets.size()));
}

}  // namespace foothold::mesh
