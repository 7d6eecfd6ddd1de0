// The table of errors against the interface file, which is what clients read.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "foothold/msg/errors.hpp"

namespace foothold::msg {
namespace {

std::map<std::string, int> constants_of_idl() {
  std::ifstream file(FOOTHOLD_IDL);
  EXPECT_TRUE(file.good()) << FOOTHOLD_IDL;
  std::map<std::string, int> constants;
  const std::regex line_form(R"(const unsigned short (\w+) = (\d+);.*)");
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_match(line, match, line_form)) constants[match[1]] = std::stoi(match[2]);
  }
  return constants;
}

TEST(Errors, TableHoldsEveryConstantOfTheInterfaceFile) {
  auto constants = constants_of_idl();
  ASSERT_GT(constants.size(), 30u);
  for (const char* not_an_error : {"NO_ERROR", "PLUGIN_FIRST", "PLUGIN_LAST"}) EXPECT_EQ(constants.erase(not_an_error), 1u);
  for (const ErrorKind& kind : error_kinds()) {
    const auto constant = constants.find(std::string(kind.name));
    ASSERT_NE(constant, constants.end()) << kind.name;
    EXPECT_EQ(constant->second, kind.code) << kind.name;
    constants.erase(constant);
  }
  for (const auto& [name, code] : constants) ADD_FAILURE() << name << " = " << code << " has no entry in the table";
}

TEST(Errors, NumbersAreUniqueAndInTheirHundreds) {
  std::set<int> seen;
  for (const ErrorKind& kind : error_kinds()) {
    EXPECT_TRUE(seen.insert(kind.code).second) << kind.name;
    EXPECT_TRUE(kind.code >= 101 && kind.code < 600) << kind.name;
  }
}

TEST(Errors, MakeErrorFillsNameStageAndHint) {
  const Error error = make_error(QUEUE_FULL, "64 requests wait");
  EXPECT_EQ(error.code(), QUEUE_FULL);
  EXPECT_EQ(error.name(), "QUEUE_FULL");
  EXPECT_EQ(error.stage(), "queue");
  EXPECT_FALSE(error.hint().empty());
  EXPECT_TRUE(error.retryable());
}

}  // namespace
}  // namespace foothold::msg
