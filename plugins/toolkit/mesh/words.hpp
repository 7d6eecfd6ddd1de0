// Inside of the mesh library: a text, word by word and line by line. Lines end with LF, CR LF or CR.
#pragma once

#include <string>
#include <string_view>

namespace foothold::mesh {

class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  // The next word, on whatever line; empty at the end of the text.
  std::string_view next();
  // The next word of this line; empty at its end.
  std::string_view next_in_line();
  // To the beginning of the next line.
  void skip_line();
  bool at_end() const { return rest_.empty(); }
  // What was not read yet.
  std::string_view rest() const { return rest_; }

  // A number, which may be infinite or none at all. Throws InvalidScene.
  double number(std::string_view word) const;
  std::int64_t integer(std::string_view word) const;
  // Throws InvalidScene with the line.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void skip_blanks();

  std::string_view rest_;
  std::size_t line_ = 1;
};

// A word of the file for a message: in quotes, not all of it if it is long.
std::string shown(std::string_view word);

}  // namespace foothold::mesh
