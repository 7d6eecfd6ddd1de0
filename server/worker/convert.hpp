// Between the wire's messages and the planner's domain types.
#pragma once

#include <foothold.h>
#include <worker.h>

#include <optional>
#include <string>
#include <vector>

#include "foothold/planner.hpp"

namespace foothold::server {

Request to_request(const msg::PlanRequest& request, double budget_left);
RobotModel to_model(const frame::Load& load);

// Everything but request, index, margins and shapes.
msg::Step to_message(const Step& step);
std::vector<msg::Shape> to_message(const std::vector<Shape>& shapes);
std::vector<msg::Margin> to_message(const std::vector<Margin>& margins);

// What a message must not hold: the path of a number that is not finite, of a rotation that is none or of a text that is not clean,
// and why. Nothing if sound.
std::optional<std::string> unsound_part(const Step& step);
std::optional<std::string> unsound_part(const std::vector<Shape>& shapes);

}  // namespace foothold::server
