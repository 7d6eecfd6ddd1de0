// Which server has a plan, when the caller's thread, the keeper and the bus decide at the same time: a decision made on what
// another thread has changed since does nothing.
#include <gtest/gtest.h>

#include "foothold/msg/ids.hpp"
#include "plan_state.hpp"

namespace foothold::test {
namespace {

using client::PlanState;

class Moves : public testing::Test {
 protected:
  bool lose(const msg::Id& server) {
    plan_.set_server_lost(server, true, now_);
    return plan_.server_lost();
  }

  bool moves(const msg::Id& server) {
    const std::uint64_t before = plan_.traffic().moves;
    plan_.move(server, now_);
    return plan_.traffic().moves > before;
  }

  const msg::Id a_ = msg::id_of("a"), b_ = msg::id_of("b"), c_ = msg::id_of("c");
  const PlanState::Time now_ = PlanState::Clock::now();
  PlanState plan_{[] {
                    msg::PlanRequest request;
                    request.id(msg::id_of("request"));
                    request.robot("robot");
                    return request;
                  }(),
                  PlanState::Origin::kSubmitted,
                  0,
                  {},
                  {},
                  {}};
};

// The request was on its way to the first already: at the second it would begin again, and the first be told that it has moved.
TEST_F(Moves, TheFirstChoiceStays) {
  plan_.choose(a_, "revision");
  plan_.choose(b_, "another");
  EXPECT_EQ(plan_.server(), a_);
  EXPECT_EQ(plan_.request().server(), a_);
}

TEST_F(Moves, TheLossOfAnotherServerIsNotItsOwn) {
  plan_.choose(a_);
  EXPECT_FALSE(lose(b_));
  EXPECT_TRUE(lose(a_));
  ASSERT_TRUE(moves(b_));
  EXPECT_FALSE(lose(a_)) << "it has left";
  EXPECT_FALSE(plan_.wants_another());
  EXPECT_EQ(plan_.server(), b_);
}

TEST_F(Moves, NeverToAServerThatHadIt) {
  plan_.choose(a_);
  ASSERT_TRUE(lose(a_));
  EXPECT_FALSE(moves(a_));
  ASSERT_TRUE(moves(b_));
  ASSERT_TRUE(lose(b_));
  for (const msg::Id& had_it : {a_, b_}) EXPECT_FALSE(moves(had_it));
  EXPECT_EQ(plan_.server(), b_);
  EXPECT_TRUE(moves(c_));
  EXPECT_EQ(plan_.request().server(), c_);
  EXPECT_EQ(plan_.left(), (std::vector<msg::Id>{a_, b_}));
}

}  // namespace
}  // namespace foothold::test
