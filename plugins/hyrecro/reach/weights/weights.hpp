// The weights files, compiled in, since a worker finds its plugin and nothing beside it.
#pragma once

#include <string_view>

namespace foothold::hyrecro {

extern const std::string_view kFaceWeights;
extern const std::string_view kTransitionWeights;

}  // namespace foothold::hyrecro
