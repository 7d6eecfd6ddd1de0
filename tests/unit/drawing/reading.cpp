// A walk over tinyxml2's tree.
#include "reading.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <functional>

namespace foothold::drawing {
namespace {

void walk(const tinyxml2::XMLElement* from, const std::function<void(const tinyxml2::XMLElement*)>& visit) {
  if (from == nullptr) return;
  visit(from);
  for (const auto* child = from->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) walk(child, visit);
}

bool has_class(const tinyxml2::XMLElement* element, const std::string& wanted) {
  const char* classes = element->Attribute("class");
  if (classes == nullptr) return false;
  if (wanted.empty()) return true;
  const std::string padded = " " + std::string(classes) + " ";
  return padded.find(" " + wanted + " ") != std::string::npos;
}

}  // namespace

Picture::Picture(const std::string& svg) {
  document_.Parse(svg.data(), svg.size());
  EXPECT_FALSE(document_.Error()) << document_.ErrorStr();
  EXPECT_TRUE(root() != nullptr && std::string(root()->Name()) == "svg");
}

const tinyxml2::XMLElement* Picture::part(const std::string& id) const {
  const tinyxml2::XMLElement* found = nullptr;
  walk(root(), [&](const tinyxml2::XMLElement* element) {
    if (const char* own = element->Attribute("id"); own != nullptr && id == own) found = element;
  });
  return found;
}

std::vector<std::string> Picture::texts(const tinyxml2::XMLElement* from, const std::string& tag) {
  std::vector<std::string> found;
  walk(from, [&](const tinyxml2::XMLElement* element) {
    if (tag == element->Name() && element->GetText() != nullptr) found.emplace_back(element->GetText());
  });
  return found;
}

std::vector<std::string> Picture::attributes(const tinyxml2::XMLElement* from, const std::string& name_of_class,
                                             const char* attribute) {
  std::vector<std::string> found;
  walk(from, [&](const tinyxml2::XMLElement* element) {
    if (!has_class(element, name_of_class)) return;
    const char* value = element->Attribute(attribute);
    found.emplace_back(value == nullptr ? "" : value);
  });
  return found;
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> found;
  for (const char* at = text.c_str(); *at != '\0';) {
    const bool begins = std::isdigit(static_cast<unsigned char>(at[0])) != 0 ||
                        (at[0] == '-' && std::isdigit(static_cast<unsigned char>(at[1])) != 0);
    char* end = nullptr;
    if (begins) found.push_back(std::strtod(at, &end));
    at = begins ? end : at + 1;
  }
  return found;
}

}  // namespace foothold::drawing
