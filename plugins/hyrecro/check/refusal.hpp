// How HyReCRo's judge says no: as all judges do.
#pragma once

#include "judge/refusal.hpp"

namespace foothold::hyrecro {
using namespace judge;
}
