#pragma once

#include <span>

#include "core/limits/segment_limits.h"
#include "core/trajectory/pulse_train.h"

namespace feedscope {

/// Highest speed of the corner at the other end of a block of length `length` [mm] whose slower corner is
/// passed at `speed`: f = c V^2/(c V - L) with c = n T1/2 `half_delay`; infinite if c V <= L (README.md in
/// this folder).
double short_block_speed(double speed, double length, double half_delay);

/// Lowers corner speeds until every short block of `train` can change from one to the other. Two passes are
/// enough, because a cap is never below the slower speed that sets it. `corner_speeds`: V_c at the start of
/// every block [mm/s]; the first, a stop, is not used.
void cap_by_short_blocks(const PulseTrain& train, std::span<double> corner_speeds);

/// Lays all pulses of `train` one after the other. `limits`: highest feed of every block. Where T_v of that
/// feed would be negative: f = c (V_a^2 + V_b^2)/(c (V_a + V_b) - L), T_v = 0.
void lay_pulses(PulseTrain& train, std::span<const SpeedBound> limits, std::span<const double> corner_speeds);

}  // namespace feedscope
