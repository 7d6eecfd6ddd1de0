// A robot's model on its way from the server to its worker.
#include <gtest/gtest.h>

#include "foothold/msg/cdr.hpp"
#include "worker/convert.hpp"

namespace foothold::server {
namespace {

TEST(Load, NumbersAndTextsReachTheModel) {
  frame::Load sent;
  sent.robot("biped");
  frame::ModelEntry& number = sent.model().emplace_back();
  number.path("hip.limits");
  number.values({-1.5, 0.25});
  number.unit("rad");
  number.source("public");
  frame::ModelText& text = sent.texts().emplace_back();
  text.path("urdf");
  text.text("<robot name=\"biped\">\n\u00e4</robot>\n");

  const auto arrived = msg::decode<frame::Load>(msg::encode(sent));
  ASSERT_TRUE(arrived.has_value());
  const RobotModel model = to_model(*arrived);
  EXPECT_EQ(model.numbers("hip.limits", "rad"), (std::vector<double>{-1.5, 0.25}));
  EXPECT_EQ(model.quantities().at("hip.limits").source, "public");
  EXPECT_EQ(model.text("urdf"), sent.texts()[0].text());
  EXPECT_EQ(model.texts().size(), 1u);
}

}  // namespace
}  // namespace foothold::server
