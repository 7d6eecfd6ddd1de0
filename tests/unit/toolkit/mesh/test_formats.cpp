// STL, OBJ and PLY as another library (assimp) reads them, in all the manners that programs write them; and what is refused, with
// the line.
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cstring>
#include <random>

#include "foothold/errors.hpp"
#include "mesh/formats.hpp"

namespace foothold::mesh {
namespace {

using Polygons = std::vector<std::vector<std::array<double, 3>>>;

Polygons sorted(Polygons polygons) {
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

Polygons ours(const Faces& faces) {
  Polygons out;
  std::size_t begin = 0;
  for (const std::size_t end : faces.ends) {
    out.emplace_back();
    for (; begin < end; ++begin) {
      const Vector3d& v = faces.vertices.at(static_cast<std::size_t>(faces.corners.at(begin)));
      out.back().push_back({v.x(), v.y(), v.z()});
    }
  }
  return sorted(out);
}

// It keeps faces by material and group, in an order of its own.
Polygons by_assimp(const std::string& octets, const char* format) {
  static Assimp::Importer importer;  // to make one takes longer than to read a small file
  const aiScene* scene = importer.ReadFileFromMemory(octets.data(), octets.size(), 0, format);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  Polygons out;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m)
    for (unsigned f = 0; f < scene->mMeshes[m]->mNumFaces; ++f) {
      out.emplace_back();
      const aiFace& face = scene->mMeshes[m]->mFaces[f];
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        const aiVector3D& v = scene->mMeshes[m]->mVertices[face.mIndices[c]];
        out.back().push_back({v.x, v.y, v.z});
      }
    }
  return sorted(out);
}

// Coordinates that single precision holds exactly.
struct Soup {
  explicit Soup(std::uint64_t seed, std::size_t most_corners) {
    std::mt19937_64 random(seed);
    const auto coordinate = [&] { return (static_cast<double>(random() % 4096) - 2048.0) / 64.0; };
    for (std::size_t k = 0; k < 5 + random() % 20; ++k) vertices.push_back({coordinate(), coordinate(), coordinate()});
    for (std::size_t k = 0; k < 1 + random() % 20; ++k) {
      faces.emplace_back();
      for (std::size_t c = 0; c < 3 + random() % (most_corners - 2); ++c) faces.back().push_back(random() % vertices.size());
    }
  }
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::vector<std::size_t>> faces;
};

std::string text(const std::array<double, 3>& v, std::uint64_t manner) {
  char out[120];
  std::snprintf(out, sizeof out, manner % 2 == 0 ? "%.9g %.9g %.9g" : "%+.8e \t%f  %.8E", v[0], v[1], v[2]);
  return out;
}

std::string as_text_stl(const Soup& soup, std::uint64_t manner) {
  std::string out = manner % 3 == 0 ? "solid\n" : "solid a name facet\n";
  for (std::size_t k = 0; k < soup.faces.size(); ++k) {
    if (manner % 3 == 1 && k == soup.faces.size() / 2) out += "endsolid a name\nsolid b\n";
    out += "  facet normal 0 0 1\n    outer loop\n";
    for (const std::size_t c : soup.faces[k]) out += "      vertex " + text(soup.vertices[c], manner) + "\n";
    out += "    endloop\n  endfacet\n";
  }
  return out + "endsolid\n";
}

template <class Number>
void append(std::string& out, Number number, bool big = false) {
  std::array<char, sizeof(Number)> octets = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (big) std::reverse(octets.begin(), octets.end());
  out.append(octets.data(), octets.size());
}

std::string as_binary_stl(const Soup& soup) {
  std::string out(80, 's');
  append(out, static_cast<std::uint32_t>(soup.faces.size()));
  for (const auto& face : soup.faces) {
    out.append(12, '\0');
    for (const std::size_t c : face)
      for (const double x : soup.vertices[c]) append(out, static_cast<float>(x));
    out.append(2, 'a');
  }
  return out;
}

std::string as_obj(const Soup& soup, std::uint64_t manner) {
  const std::string end = manner % 2 == 0 ? "\n" : "\r\n";
  std::string out = "# written by a test" + end + "mtllib a.mtl" + end + "o thing" + end;
  for (const auto& v : soup.vertices) out += "v " + text(v, manner) + (manner % 5 == 1 ? " 0.5 0.5 1" : "") + end;
  out += "vt 0 0" + end + "vn 0 0 1" + end + end + "s off" + end;
  for (const auto& face : soup.faces) {
    out += "f";
    for (const std::size_t c : face) {
      const auto last = static_cast<std::int64_t>(soup.vertices.size());
      const std::int64_t index = manner % 3 == 0 ? static_cast<std::int64_t>(c) - last : static_cast<std::int64_t>(c) + 1;
      out += " " + std::to_string(index) + (manner % 4 == 1 ? "/1/1" : manner % 4 == 2 ? "//1" : manner % 4 == 3 ? "/1" : "");
    }
    out += end;
  }
  return out;
}

std::string as_ply(const Soup& soup, std::uint64_t manner) {
  const bool ascii = manner % 3 == 0, big = manner % 3 == 2, doubles = manner % 2 == 0;
  const std::string real = doubles ? "double" : "float32";
  std::string out = "ply\nformat " +
                    std::string(ascii ? "ascii"
                                : big ? "binary_big_endian"
                                      : "binary_little_endian") +
                    " 1.0\ncomment element face 7\nobj_info none\nelement vertex " + std::to_string(soup.vertices.size()) +
                    "\nproperty " + real + " x\nproperty " + real + " y\nproperty " + real +
                    " z\nproperty uchar red\nelement face " + std::to_string(soup.faces.size()) +
                    "\nproperty list uchar int vertex_ind" + (manner % 5 == 0 ? "ex" : "ices") +
                    "\nproperty short flags\nend_header\n";
  for (const auto& v : soup.vertices) {
    if (ascii) out += text(v, manner) + " 255\n";
    for (const double x : v) {
      if (ascii) break;
      if (doubles)
        append(out, x, big);
      else
        append(out, static_cast<float>(x), big);
    }
    if (!ascii) out += '\xff';
  }
  for (const auto& face : soup.faces) {
    if (ascii) {
      out += std::to_string(face.size());
      for (const std::size_t c : face) out += " " + std::to_string(c);
      out += " -3\n";
      continue;
    }
    append(out, static_cast<std::uint8_t>(face.size()));
    for (const std::size_t c : face) append(out, static_cast<std::int32_t>(c), big);
    append(out, std::int16_t{-3}, big);
  }
  return out;
}

TEST(MeshFormats, AreReadAsAssimpReadsThem) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Soup triangles(seed, 3), polygons(seed, 7);
    const std::string stl = as_text_stl(triangles, seed), octets = as_binary_stl(triangles);
    ASSERT_EQ(ours(read_stl(stl)), by_assimp(stl, "stl"));
    ASSERT_EQ(ours(read_stl(octets)), by_assimp(octets, "stl"));
    const std::string obj = as_obj(polygons, seed);
    ASSERT_EQ(ours(read_obj(obj)), by_assimp(obj, "obj")) << obj;
    const std::string ply = as_ply(polygons, seed);
    ASSERT_EQ(ours(read_ply(ply)), by_assimp(ply, "ply"));
  }
}

TEST(MeshFormats, TakeWhatIsWrittenMoreRarely) {
  const Polygons wanted{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_EQ(ours(read_obj("v 0 0 0 1\rv 1 0 0 \\\n 1\nv 0 1 0 # a comment\nf 1 \\\r\n  2 3")), wanted);
  EXPECT_EQ(ours(read_stl("SOLID A\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\n"
                          "ENDFACET\nENDSOLID A")),
            wanted);
  EXPECT_EQ(ours(read_ply("ply\r\nformat ascii 1.0\r\nelement edge 1\r\nproperty list uint8 int32 ends\r\nelement vertex 3\r\n"
                          "property list uchar float more\r\nproperty double z\r\nproperty double x\r\nproperty double y\r\n"
                          "element face 1\r\nproperty list uchar uint vertex_indices\r\nproperty list uchar uint others\r\n"
                          "end_header\r\n2 0 1\r\n0 0 0 0\r\n2 5 6 0 1 0\r\n0 0 0 1\r\n3 0 1 2 1 7\r\n")),
            wanted);
}

void expect_refused(Faces (*read)(std::string_view), const std::string& octets, const std::string& message) {
  try {
    read(octets);
    ADD_FAILURE() << "not refused: " << message;
  } catch (const InvalidScene& fault) {
    EXPECT_NE(std::string(fault.what()).find(message), std::string::npos) << fault.what();
  }
}

TEST(MeshFormats, RefuseWithTheLine) {
  const std::string head = "ply\nformat ascii 1.0\n",
                    vertex = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n", end = "end_header\n";
  expect_refused(read_stl, "", "neither 'solid' nor 84 octets");
  expect_refused(read_stl, std::string(90, 'x'), "promises 2021161080 triangles, which take 101058054084 octets, and has 90");
  expect_refused(read_stl, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 z 0\n", "line 5: 'z' is no number");
  expect_refused(read_stl, "solid a\nfacet normal 0 0 1\nouter loop\nendloop\n", "line 4: 'vertex' is missing, there is 'endloop'");
  expect_refused(read_stl, "solid a\n", "the mesh ends early");
  expect_refused(read_obj, "v 0 0\n", "line 1: a number is missing");
  expect_refused(read_obj, "v 0 0 0 2\n", "a weight, which must be 1");
  expect_refused(read_obj, "v 0 0 0 1 1\n", "has 5 numbers");
  expect_refused(read_obj, "v 0 0 0\nf 1 0 1\n", "line 2: a face names vertex 0");
  expect_refused(read_obj, "f 1 x 1\n", "'x' is no whole number");
  expect_refused(read_obj, "v 0 0 0\nl 1 1\n", "is a point or a line");
  expect_refused(read_obj, "\ncurv 0 1 1 2\n", "line 2: 'curv' is not known of OBJ, or no polygon");
  expect_refused(read_ply, "", "does not begin with 'ply'");
  expect_refused(read_ply, "ply\n", "header has no end");
  expect_refused(read_ply, "ply\n" + end, "says no format");
  expect_refused(read_ply, "ply\nformat ascii 2.0\n", "must be 1.0");
  expect_refused(read_ply, "ply\nformat text 1.0\n", "is 'text'");
  expect_refused(read_ply, head + "property float x\n", "line 3: a property stands before the first element");
  expect_refused(read_ply, head + "element vertex -1\n", "negative count");
  expect_refused(read_ply, head + "element vertex 9\n" + end, "element 'vertex' has no property");
  expect_refused(read_ply, head + "element vertex 9\nproperty float x\n" + end, "a vertex has no y");
  expect_refused(read_ply, head + "element vertex 9\nproperty half x\n", "'half' is no type");
  expect_refused(read_ply, head + "element tristrips 1\nproperty list int int vertex_indices\n" + end, "strips");
  expect_refused(read_ply, head + vertex + end + "0 0 0\n0 0\n", "the mesh ends early");
  expect_refused(read_ply, head + face + end + "-1\n", "a list has a negative count");
  expect_refused(read_ply, head + face + end + "1 0.5\n", "is no whole number");
  expect_refused(read_ply, head + "element face 1\nproperty int a\n" + end + "1\n", "a face has no vertex_indices");
  expect_refused(read_ply, "ply\nformat binary_little_endian 1.0\n" + face + end + "\x03", "it ends early");
}

}  // namespace
}  // namespace foothold::mesh
