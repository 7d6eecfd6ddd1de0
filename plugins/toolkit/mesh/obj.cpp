// Wavefront OBJ: vertices and the polygons between them.
#include <algorithm>

#include "foothold/errors.hpp"
#include "mesh/formats.hpp"
#include "mesh/joining.hpp"
#include "mesh/words.hpp"

namespace foothold::mesh {
namespace {

// Of no meaning for where the surface is.
constexpr std::string_view kLeftOut[] = {"vn",  "vt",         "vp",        "g",        "o",       "s",
                                         "mg",  "usemtl",     "mtllib",    "usemap",   "maplib",  "bevel",
                                         "lod", "shadow_obj", "trace_obj", "c_interp", "d_interp"};

class Reader {
 public:
  explicit Reader(std::string_view text) : words_(text) {}

  Faces read() {
    for (; !words_.at_end(); words_.skip_line()) {
      const std::string_view key = next();
      if (key.empty()) continue;
      if (key == "v")
        read_vertex();
      else if (key == "f" || key == "fo")  // what f was called in the format's second version
        read_face();
      else if (key == "p" || key == "l")
        throw InvalidScene(triangle(faces_.ends.size()), "is a point or a line, no triangle");
      else if (std::ranges::find(kLeftOut, key) == std::end(kLeftOut))
        words_.fail(shown(key) + " is not known of OBJ, or no polygon");
    }
    return std::move(faces_);
  }

 private:
  // The next word of this line and those that go on with it; empty at its end or before a comment.
  std::string_view next() {
    for (;;) {
      const std::string_view word = words_.next_in_line();
      if (word.starts_with('#')) return {};
      if (word != "\\") return word;
      words_.skip_line();
    }
  }

  void read_vertex() {
    Vector3d vertex;
    for (double& x : vertex) x = words_.number(next());
    double weight = 1.0;
    int more = 0;
    for (std::string_view word = next(); !word.empty(); word = next()) {
      const double value = words_.number(word);
      if (more++ == 0) weight = value;
    }
    // Three more are a colour.
    if (more != 0 && more != 1 && more != 3) words_.fail("a vertex has " + std::to_string(3 + more) + " numbers, not 3, 4 or 6");
    if (more == 1 && weight != 1.0) words_.fail("a vertex has a weight, which must be 1");
    faces_.vertices.push_back(vertex);
  }

  // Each corner: index of the vertex, and, behind strokes, those of texture and normal.
  void read_face() {
    for (std::string_view word = next(); !word.empty(); word = next()) {
      const std::int64_t index = words_.integer(word.substr(0, word.find('/')));
      if (index == 0) words_.fail("a face names vertex 0; they count from 1, or back from -1");
      faces_.corners.push_back(index > 0 ? index - 1 : static_cast<std::int64_t>(faces_.vertices.size()) + index);
    }
    faces_.ends.push_back(faces_.corners.size());
  }

  Words words_;
  Faces faces_;
};

}  // namespace

Faces read_obj(std::string_view text) { return Reader(text).read(); }

}  // namespace foothold::mesh
