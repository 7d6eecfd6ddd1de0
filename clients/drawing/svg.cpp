// Numbers, escapes and elements. Everything is written independently of the process's locale.
#include "svg.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace foothold::drawing {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// The length of the valid UTF-8 character that `text` begins with and that XML allows; 0: none.
std::size_t character_length(std::string_view text) {
  const auto octet = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = octet(0);
  if (first < 0x80) return (first >= 0x20 || first == '\t' || first == '\n' || first == '\r') && first != 0x7F ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((octet(i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (octet(i) & 0x3FU);
  }
  static constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return 0;
  return code == 0xFFFE || code == 0xFFFF ? 0 : length;
}

std::string path_data(const Points& points, bool closed) {
  std::string data;
  for (std::size_t i = 0; i < points.size(); ++i) {
    data += i == 0 ? 'M' : 'L';
    data += compact(points[i].x());
    data += ' ';
    data += compact(points[i].y());
  }
  if (closed) data += 'Z';
  return data;
}

}  // namespace

std::string compact(double value) {
  std::array<char, 340> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 3).ptr;
  std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  while (text.ends_with('0')) text.remove_suffix(1);
  if (text.ends_with('.')) text.remove_suffix(1);
  return text == "-0" ? "0" : std::string(text);
}

std::string readable(double value) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 4).ptr;
  return {buffer.data(), end};
}

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      out += kReplacement;
      text.remove_prefix(1);
      continue;
    }
    switch (text.front()) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return out;
}

std::string shortened(std::string_view text, std::size_t characters) {
  std::size_t at = 0, count = 0, cut = 0;
  while (at < text.size()) {
    if (count + 1 == characters) cut = at;
    if (count == characters) return std::string(text.substr(0, cut)) + "\xE2\x80\xA6";
    at += std::max<std::size_t>(1, character_length(text.substr(at)));
    ++count;
  }
  return std::string(text);
}

std::vector<std::string> wrapped(std::string_view text, std::size_t characters, std::size_t most) {
  std::vector<std::string> lines;
  while (lines.size() + 1 < most && shortened(text, characters) != text) {
    // At the last space up to the first character that does not fit; else between two characters.
    std::size_t fits = 0;
    for (std::size_t count = 0; count < characters; ++count) fits += std::max<std::size_t>(1, character_length(text.substr(fits)));
    const std::size_t space = text.substr(0, fits + 1).rfind(' ');
    const std::size_t cut = space == std::string_view::npos || space == 0 ? fits : space;
    lines.emplace_back(text.substr(0, cut));
    text.remove_prefix(cut);
    if (text.starts_with(' ')) text.remove_prefix(1);
  }
  lines.push_back(shortened(text, characters));
  return lines;
}

double text_width(std::string_view text, double font_size) {
  std::size_t characters = 0;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) ++characters;
  constexpr double kWidthOfCharacter = 0.6;  // of the font's size; DejaVu Sans, the widest of the usual ones
  return static_cast<double>(characters) * font_size * kWidthOfCharacter;
}

std::string closed_path(const Points& points) { return path_data(points, true); }
std::string open_path(const Points& points) { return path_data(points, false); }

void Svg::open(std::string_view tag_and_attributes) {
  text_ += '<';
  text_ += tag_and_attributes;
  text_ += ">\n";
}

void Svg::close(std::string_view tag) {
  text_ += "</";
  text_ += tag;
  text_ += ">\n";
}

void Svg::element(std::string_view tag_and_attributes) {
  text_ += '<';
  text_ += tag_and_attributes;
  text_ += "/>\n";
}

void Svg::path(std::string_view classes, const std::string& data, std::string_view more) {
  text_ += "<path class='";
  text_ += classes;
  text_ += "' d='";
  text_ += data;
  text_ += '\'';
  if (!more.empty()) text_ += ' ';
  text_ += more;
  text_ += "/>\n";
}

void Svg::text(std::string_view classes, double x, double y, std::string_view words, std::string_view anchor) {
  text_ += "<text class='";
  text_ += classes;
  text_ += "' x='" + compact(x) + "' y='" + compact(y) + '\'';
  if (anchor != "start") text_ += " text-anchor='" + std::string(anchor) + '\'';
  text_ += '>' + escaped(words) + "</text>\n";
}

void Svg::line(std::string_view classes, const Vector3d& a, const Vector3d& b) { path(classes, open_path({a, b})); }

void Svg::circle(std::string_view classes, const Vector3d& centre, double radius) {
  element("circle class='" + std::string(classes) + "' cx='" + compact(centre.x()) + "' cy='" + compact(centre.y()) + "' r='" +
          compact(radius) + "'");
}

void Svg::tooltip(std::string_view words) { text_ += "<title>" + escaped(words) + "</title>\n"; }

}  // namespace foothold::drawing
