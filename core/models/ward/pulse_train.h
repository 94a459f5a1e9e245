#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/limits/segment_limits.h"
#include "core/trajectory/filtered_motion.h"

namespace feedscope {

/// A straight part of the path that is commanded without a stop: a line, or a chord of an arc.
struct Link {
  Vec3 start;                 ///< [mm]
  Vec3 direction;             ///< unit
  double length = 0;          ///< > 0 [mm]
  SpeedBound feed;            ///< what the pulse may reach [mm/s]
  double turn = 0;            ///< direction change towards the next link [rad]; 0 at the last
  std::uint32_t segment = 0;  ///< programmed
};

/// The pulses of one link: V_c left and right for T_b, the feed between for T_v.
struct LinkPulses {
  double feed = 0;        ///< F, or f of the short-block rule [mm/s]
  double width_left = 0;  ///< T_b [s]
  double width = 0;       ///< T_v [s]
  double width_right = 0;
  double time() const { return width_left + width + width_right; }
};

/// Highest speed of the corner at the other end of a block of length `length` [mm] whose slower corner is
/// passed at `speed`: f = c V^2/(c V - L) with c = n T1/2 `half_delay`; infinite if c V <= L (MODELS section
/// 5).
double short_block_speed(double speed, double length, double half_delay);

/// Lowers corner speeds until every short block can change from one to the other. Two passes settle it,
/// because a cap is never below the slower speed that sets it. `corner_speeds`: links.size() + 1, first and
/// last taken as standstill without a blending pulse.
void cap_by_short_blocks(std::span<const Link> links, double half_delay, std::span<double> corner_speeds);

/// T_b, T_v and feed of link `i`. Where T_v of the feed would be negative:
/// f = c (V_a^2 + V_b^2)/(c (V_a + V_b) - L), T_v = 0.
LinkPulses link_pulses(std::span<const Link> links, std::size_t i, double half_delay,
                       std::span<const double> corner_speeds);

/// What is sent through the filters.
struct PulseTrain {
  std::vector<Pulse> pulses;
  std::vector<double> link_start;  ///< links.size() + 1, the last the end [s]
};

/// The pulses of all links, one after the other, and the standstill at `end`; neighbouring equal pulses of a
/// link are one.
PulseTrain lay_pulses(std::span<const Link> links, double half_delay, std::span<const double> corner_speeds,
                      const Vec3& end);

}  // namespace feedscope
