// The rules of idl/PROTOCOL.md for who watches and for more than one server: P31 and on.
#include <gtest/gtest.h>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

msg::PlanRequest of_unit(const std::string& name, const std::string& unit) {
  auto request = good_request(name);
  request.unit(unit);
  return request;
}

TEST(P31, EveryEventNamesRobotAndUnit) {
  World world;
  for (const char* name : {"r1", "r2", "waiting"}) world.submit(of_unit(name, std::string("unit of ") + name));
  world.query(msg::id_of("waiting"), 0, World::kOther);
  world.end(msg::id_of("r1"), msg::SUCCEEDED);
  world.end(msg::id_of("waiting"), msg::FAILED, msg::NO_PATH);
  auto refused = of_unit("refused", "unit of refused");
  refused.budget(-1.0);
  world.submit(refused);
  world.restart();  // r2 ends
  world.query(msg::id_of("waiting"));
  std::size_t seen = 0;
  for (const char* name : {"r1", "r2", "waiting", "refused"})
    for (const Id& client : {World::kClient, World::kOther})
      for (const auto& event : world.events(msg::id_of(name), client)) {
        ++seen;
        EXPECT_EQ(event.robot(), "walker") << name;
        EXPECT_EQ(event.unit(), std::string("unit of ") + name);
      }
  EXPECT_EQ(seen, 10U);
}

TEST(P31, EveryStepNamesItsServerAlsoAfterARestart) {
  World world;
  auto request = good_request();
  request.resume(true);
  world.submit(request);
  world.step(request.id(), 0);
  world.restart();
  world.step(request.id(), 0);  // the same again: it is compared with what the journal holds
  world.step(request.id(), 1);
  std::size_t seen = 0;
  for (const auto& message : world.outbox.messages) {
    if (message.event) continue;
    const auto step = msg::decode<msg::Step>(message.step);
    ASSERT_TRUE(step);
    EXPECT_EQ(step->server(), world.options.server);
    ++seen;
  }
  EXPECT_EQ(seen, 3U);
}

TEST(P31, ARequestOfNamesThatBreakTheLimitsIsNotEchoed) {
  World world;
  auto request = of_unit("too long", std::string(5000, 'u'));
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().field(), "unit");
  EXPECT_TRUE(world.last(request.id()).unit().empty());
  request.id(msg::kNoId);
  world.submit(request);
  EXPECT_TRUE(world.last(msg::kNoId).unit().empty());
}

}  // namespace
}  // namespace foothold::server::testing
