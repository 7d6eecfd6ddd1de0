// Reading a picture back: well-formed or not, and what is in it.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <vector>

namespace foothold::drawing {

// Fails the test unless `svg` is one well-formed XML document whose root is <svg>.
class Picture {
 public:
  explicit Picture(const std::string& svg);
  // The element with this id, or nothing.
  const tinyxml2::XMLElement* part(const std::string& id) const;
  // All text of the elements of this tag below `from`, in order.
  static std::vector<std::string> texts(const tinyxml2::XMLElement* from, const std::string& tag);
  // The attribute of every element with this class below `from`, in order. A class matches as a whole word; an empty
  // one matches every element that has any.
  static std::vector<std::string> attributes(const tinyxml2::XMLElement* from, const std::string& name_of_class,
                                             const char* attribute);
  const tinyxml2::XMLElement* root() const { return document_.RootElement(); }

 private:
  tinyxml2::XMLDocument document_;
};

// The numbers in path data or any other text, in order.
std::vector<double> numbers_in(const std::string& text);

}  // namespace foothold::drawing
