#pragma once

#include <cstdint>
#include <string>

#include "tests/contract/random_case.h"

namespace feedscope::contract {

/// random_case() on a shipped machine with rotary axes, whose limits are changed, with tool length and part
/// zero: under tool centre point control its lines turn these axes by 1e-4 to 100 degrees, some of its rapids
/// too. The same for the same arguments.
Case rotary_case(const std::string& model, std::uint64_t seed, std::uint64_t number);

/// 1 to 8 blocks of up to 1 m, some of them rapids, under tool centre point control on a shipped machine with
/// rotary axes, its part zero up to 600 mm away on each axis: along most the axes turn by up to 5000 degrees.
Case far_turn_case(const std::string& model, std::uint64_t seed, std::uint64_t number);

}  // namespace feedscope::contract
