// Writing SVG: numbers, text and paths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polygon.hpp"

namespace foothold::drawing {

// With three decimals at most, no exponent, no "-0": "1.5", "-12.125", "0".
std::string compact(double value);
// Four significant digits, for people: "0.000275", "1.2e-07".
std::string readable(double value);
// For XML text and attributes. Octets that are not UTF-8 and characters that XML does not allow become U+FFFD.
std::string escaped(std::string_view text);
// The first `characters` characters, the last of them an ellipsis if there were more. Of valid or invalid UTF-8.
std::string shortened(std::string_view text, std::size_t characters);
// The text in lines of that many characters at most, broken at spaces where there are any; what does not fit into `most` lines is
// cut off with an ellipsis.
std::vector<std::string> wrapped(std::string_view text, std::size_t characters, std::size_t most);
// How wide a line of text is at a font size, roughly and never less than true for common letters. px
double text_width(std::string_view text, double font_size);

// Path data of one closed polygon, or of an open line.
std::string closed_path(const Points& points);
std::string open_path(const Points& points);

// A document in the making: elements one after the other, a line each.
class Svg {
 public:
  void open(std::string_view tag_and_attributes);  // "g class='x'" without angle brackets
  void close(std::string_view tag);
  // An element without content.
  void element(std::string_view tag_and_attributes);
  void path(std::string_view classes, const std::string& data, std::string_view more = {});
  // One line of text, its baseline's begin, middle or end at (x, y).
  void text(std::string_view classes, double x, double y, std::string_view words, std::string_view anchor = "start");
  void line(std::string_view classes, const Vector3d& a, const Vector3d& b);
  void circle(std::string_view classes, const Vector3d& centre, double radius);
  // A <title>: what a viewer shows when the pointer rests on the enclosing element.
  void tooltip(std::string_view words);
  void raw(std::string_view text) { text_ += text; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace foothold::drawing
