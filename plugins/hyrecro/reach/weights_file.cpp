// A trained perceptron as text and back.
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "hyrecro/reach/perceptron.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kPerLine = 8;

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error("weights of a reachability network: " + what); }

template <typename T>
T number(std::string_view word, const std::string& what) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) refuse(what + " is no number: '" + std::string(word) + "'");
  return value;
}

// The shortest that reads as the same number.
template <typename T>
std::string word_of(T value) {
  char word[32];
  return {word, std::to_chars(word, word + sizeof word, value).ptr};
}

// "name rest of the line"
std::string after(std::istream& in, const std::string& name) {
  std::string word, rest;
  if (!(in >> word) || word != name) refuse("'" + name + "' expected" + (word.empty() ? "" : ", found '" + word + "'"));
  std::getline(in >> std::ws, rest);
  return rest;
}

}  // namespace

std::string to_text(const TrainedPerceptron& t) {
  std::ostringstream out;
  std::istringstream comment(t.comment);
  for (std::string line; std::getline(comment, line);) out << "# " << line << "\n";
  out << "kind " << t.kind << "\nrobot " << t.robot << "\nclearance " << word_of(t.clearance) << "\nradius " << word_of(t.radius)
      << "\nfresh " << t.fresh << "\nseed " << t.seed << "\nreachable " << t.reachable << "\nfalse_positives " << t.false_positives
      << "\nfalse_negatives " << t.false_negatives << "\nweights " << Perceptron::kCount << "\n";
  for (std::size_t i = 0; i < Perceptron::kCount; ++i)
    out << word_of(t.net.values[i]) << ((i + 1) % kPerLine == 0 || i + 1 == Perceptron::kCount ? "\n" : " ");
  return out.str();
}

TrainedPerceptron from_text(std::string_view text) {
  std::istringstream in{std::string(text)};
  TrainedPerceptron t;
  for (std::string line; in.peek() == '#' && std::getline(in, line);) t.comment += line.substr(line.size() > 1 ? 2 : 1) + "\n";
  t.kind = after(in, "kind");
  t.robot = after(in, "robot");
  t.clearance = number<double>(after(in, "clearance"), "clearance");
  t.radius = number<double>(after(in, "radius"), "radius");
  t.fresh = number<std::size_t>(after(in, "fresh"), "fresh");
  t.seed = number<unsigned long long>(after(in, "seed"), "seed");
  t.reachable = number<std::size_t>(after(in, "reachable"), "reachable");
  t.false_positives = number<std::size_t>(after(in, "false_positives"), "false_positives");
  t.false_negatives = number<std::size_t>(after(in, "false_negatives"), "false_negatives");
  const auto count = number<std::size_t>(after(in, "weights"), "weights");
  if (count != Perceptron::kCount) refuse(std::to_string(Perceptron::kCount) + " numbers expected, not " + std::to_string(count));
  std::string word;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(in >> word)) refuse("number " + std::to_string(i + 1) + " of " + std::to_string(count) + " is missing");
    t.net.values[i] = number<float>(word, "number " + std::to_string(i + 1));
  }
  if (in >> word) refuse("nothing expected after the last number, found '" + word + "'");
  return t;
}

}  // namespace foothold::hyrecro
