// The list of members in fields.hpp against the interface file.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "foothold/msg/fields.hpp"

namespace foothold::msg {
namespace {

using Names = std::vector<std::string>;

std::map<std::string, Names> structs_of_idl() {
  std::ifstream file(FOOTHOLD_IDL);
  EXPECT_TRUE(file.good()) << FOOTHOLD_IDL;
  std::string text(std::istreambuf_iterator<char>(file), {});
  text = std::regex_replace(text, std::regex("//[^\n]*"), "");
  const std::regex struct_form(R"(struct (\w+) \{([^}]*)\})");
  const std::regex member_form(R"((\w+)\s*;)");
  std::map<std::string, Names> structs;
  for (std::sregex_iterator s(text.begin(), text.end(), struct_form), end; s != end; ++s) {
    const std::string body = (*s)[2];
    Names& names = structs[(*s)[1]];
    for (std::sregex_iterator m(body.begin(), body.end(), member_form); m != end; ++m) names.push_back((*m)[1]);
  }
  return structs;
}

template <class M>
void expect_as_in_idl(std::map<std::string, Names>& structs, const char* name) {
  M message;
  Names names;
  fields(message, [&](const char* field, auto&&) { names.emplace_back(field); });
  EXPECT_EQ(names, structs[name]) << name;
  structs.erase(name);
}

TEST(Fields, AreThoseOfTheInterfaceFileInItsOrder) {
  auto structs = structs_of_idl();
  ASSERT_GT(structs.size(), 15u);
#define FOOTHOLD_EXPECT(Message) expect_as_in_idl<Message>(structs, #Message)
  FOOTHOLD_EXPECT(Vector3);
  FOOTHOLD_EXPECT(Quaternion);
  FOOTHOLD_EXPECT(Pose);
  FOOTHOLD_EXPECT(Contact);
  FOOTHOLD_EXPECT(Placement);
  FOOTHOLD_EXPECT(Shape);
  FOOTHOLD_EXPECT(ParameterSpec);
  FOOTHOLD_EXPECT(Parameter);
  FOOTHOLD_EXPECT(Margin);
  FOOTHOLD_EXPECT(Attribute);
  FOOTHOLD_EXPECT(Error);
  FOOTHOLD_EXPECT(PlanRequest);
  FOOTHOLD_EXPECT(CancelRequest);
  FOOTHOLD_EXPECT(StateQuery);
  FOOTHOLD_EXPECT(SceneChunk);
  FOOTHOLD_EXPECT(MotionPoint);
  FOOTHOLD_EXPECT(Step);
  FOOTHOLD_EXPECT(Summary);
  FOOTHOLD_EXPECT(PlanEvent);
  FOOTHOLD_EXPECT(SceneStatus);
  FOOTHOLD_EXPECT(RobotInfo);
  FOOTHOLD_EXPECT(ServerInfo);
#undef FOOTHOLD_EXPECT
  for (const auto& [name, names] : structs) ADD_FAILURE() << name << " has no fields()";
}

TEST(Fields, ReachTheMembersThemselves) {
  Pose pose;
  fields(pose, [](const char*, auto& part) { fields(part, [](const char*, auto& number) { number = 2.5; }); });
  EXPECT_EQ(pose.position().z(), 2.5);
  EXPECT_EQ(pose.orientation().w(), 2.5);
}

static_assert(Struct<Step> && Struct<const Step> && !Struct<double> && !Struct<std::string>);

}  // namespace
}  // namespace foothold::msg
