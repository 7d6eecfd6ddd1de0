// PLY: elements with properties, as the header declares them.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "foothold/errors.hpp"
#include "mesh/formats.hpp"
#include "mesh/words.hpp"

namespace foothold::mesh {
namespace {

static_assert(std::endian::native == std::endian::little);

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct TypeName {
  std::string_view name, other;
  Type type;
};
constexpr TypeName kTypes[] = {{"char", "int8", Type::kInt8},        {"uchar", "uint8", Type::kUint8},
                               {"short", "int16", Type::kInt16},     {"ushort", "uint16", Type::kUint16},
                               {"int", "int32", Type::kInt32},       {"uint", "uint32", Type::kUint32},
                               {"float", "float32", Type::kFloat32}, {"double", "float64", Type::kFloat64}};

struct Property {
  std::string_view name;
  std::optional<Type> count;  // of a list
  Type type = Type::kInt8;
};

struct Element {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

enum class Format { kText, kLittle, kBig };

// The values behind the header, in either form.
class Values {
 public:
  Values(Words words, Format format) : words_(words), octets_(words.rest()), format_(format) {}

  double next(Type type) {
    if (format_ == Format::kText) {
      const std::string_view word = words_.next();
      if (word.empty()) words_.fail("the mesh ends early");
      return words_.number(word);
    }
    switch (type) {
      case Type::kInt8:
        return take<std::int8_t>();
      case Type::kUint8:
        return take<std::uint8_t>();
      case Type::kInt16:
        return take<std::int16_t>();
      case Type::kUint16:
        return take<std::uint16_t>();
      case Type::kInt32:
        return take<std::int32_t>();
      case Type::kUint32:
        return take<std::uint32_t>();
      case Type::kFloat32:
        return take<float>();
      case Type::kFloat64:
        break;
    }
    return take<double>();
  }

  // A count or an index.
  std::int64_t whole(Type type) {
    const double value = next(type);
    if (!(std::abs(value) <= 4294967295.0) || value != std::floor(value)) fail("a count or an index is no whole number");
    return static_cast<std::int64_t>(value);
  }

  [[noreturn]] void fail(const std::string& reason) const {
    if (format_ == Format::kText) words_.fail(reason);
    throw InvalidScene("", "the mesh: " + reason);
  }

 private:
  template <class Number>
  Number take() {
    if (octets_.size() < sizeof(Number)) fail("it ends early");
    std::array<char, sizeof(Number)> octets;
    for (std::size_t k = 0; k < sizeof(Number); ++k) octets[format_ == Format::kBig ? sizeof(Number) - 1 - k : k] = octets_[k];
    octets_.remove_prefix(sizeof(Number));
    return std::bit_cast<Number>(octets);
  }

  Words words_;
  std::string_view octets_;
  Format format_;
};

class Reader {
 public:
  explicit Reader(std::string_view octets) : words_(octets) {}

  Faces read() {
    read_header();
    Values values(words_, format_);
    for (const Element& element : elements_)
      for (std::int64_t k = 0; k < element.count; ++k) read_element(element, values);
    return std::move(faces_);
  }

 private:
  void read_header() {
    if (words_.next_in_line() != "ply") words_.fail("the mesh is no PLY: it does not begin with 'ply'");
    bool has_format = false;
    for (;;) {
      words_.skip_line();
      if (words_.at_end()) words_.fail("the mesh's header has no end");
      const std::string_view key = words_.next_in_line();
      if (key == "end_header") break;
      if (key == "format") {
        format_ = format(words_.next_in_line());
        if (words_.next_in_line() != "1.0") words_.fail("the format's version must be 1.0");
        has_format = true;
      } else if (key == "element") {
        add_element();
      } else if (key == "property") {
        add_property();
      } else if (!key.empty() && key != "comment" && key != "obj_info") {
        words_.fail(shown(key) + " is not known in a PLY's header");
      }
    }
    words_.skip_line();
    if (!has_format) words_.fail("the mesh's header says no format");
    // What takes no room may be promised without end.
    for (const Element& element : elements_) {
      if (element.count > 0 && element.properties.empty()) words_.fail("element " + shown(element.name) + " has no property");
      if (element.count > 0 && element.name == "tristrips") words_.fail("strips of triangles are not read");
      if (element.count > 0 && element.name == "vertex")
        for (const std::string_view axis : {"x", "y", "z"})
          if (std::ranges::none_of(element.properties, [&](const Property& p) { return p.name == axis && !p.count; }))
            words_.fail("a vertex has no " + std::string(axis));
    }
  }

  Format format(std::string_view word) const {
    if (word == "ascii") return Format::kText;
    if (word == "binary_little_endian") return Format::kLittle;
    if (word == "binary_big_endian") return Format::kBig;
    words_.fail("the format must be ascii, binary_little_endian or binary_big_endian, is " + shown(word));
  }

  void add_element() {
    Element element;
    element.name = words_.next_in_line();
    element.count = words_.integer(words_.next_in_line());
    if (element.count < 0) words_.fail("element " + shown(element.name) + " has a negative count");
    elements_.push_back(std::move(element));
  }

  void add_property() {
    if (elements_.empty()) words_.fail("a property stands before the first element");
    Property property;
    std::string_view word = words_.next_in_line();
    if (word == "list") {
      property.count = type(words_.next_in_line());
      word = words_.next_in_line();
    }
    property.type = type(word);
    property.name = words_.next_in_line();
    elements_.back().properties.push_back(property);
  }

  Type type(std::string_view word) const {
    for (const TypeName& known : kTypes)
      if (word == known.name || word == known.other) return known.type;
    words_.fail(shown(word) + " is no type of a property");
  }

  void read_element(const Element& element, Values& values) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Vector3d vertex = Vector3d::Constant(NAN);
    bool has_corners = false;
    for (const Property& property : element.properties) {
      if (!property.count) {
        const double value = values.next(property.type);
        if (is_vertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
          vertex[property.name[0] - 'x'] = value;
        continue;
      }
      const bool are_corners = is_face && (property.name == "vertex_indices" || property.name == "vertex_index");
      const std::int64_t count = values.whole(*property.count);
      if (count < 0) values.fail("a list has a negative count");
      for (std::int64_t k = 0; k < count; ++k)
        if (are_corners)
          faces_.corners.push_back(values.whole(property.type));
        else
          values.next(property.type);
      has_corners = has_corners || are_corners;
    }
    if (is_vertex) faces_.vertices.push_back(vertex);
    if (is_face && !has_corners) values.fail("a face has no vertex_indices");
    if (is_face) faces_.ends.push_back(faces_.corners.size());
  }

  Words words_;
  Format format_ = Format::kText;
  std::vector<Element> elements_;
  Faces faces_;
};

}  // namespace

Faces read_ply(std::string_view octets) { return Reader(octets).read(); }

}  // namespace foothold::mesh
