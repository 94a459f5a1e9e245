#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/models/grbl/grbl_planner.h"

namespace feedscope {

enum class GrblPhase : std::uint8_t { accelerates, cruises, brakes };

/// Part of a block with constant acceleration.
struct GrblSpan {
  float from = 0;    ///< length of the block left at its beginning [mm]
  float to = 0;      ///< at its end [mm]
  float before = 0;  ///< speed at its beginning [mm/min]
  float after = 0;   ///< at its end [mm/min]
  float time = 0;    ///< as planned; negative where GrblSteps goes back [min]
  GrblPhase phase = GrblPhase::cruises;
};

/// One run of the step generator at one step rate.
struct GrblSegment {
  std::uint32_t block = 0;  ///< GrblBlock::id
  float planned = 0;        ///< time as planned [min]
  double time = 0;          ///< of the step timer; as planned where that is not simulated [s]
  bool ends_block = false;
};

/// Cuts planned blocks into segments of about 10 ms (README.md, "Segments"). As in the control, a ramp that
/// ends in a segment of several times 10 ms counts from the segment's beginning, and the next one goes back
/// by the time counted twice.
class GrblSteps {
 public:
  GrblSteps(const GrblSettings& settings, GrblPlanner& planner);

  /// Prepares the next segment of the planner's front block, which is popped at its end. The planner must not
  /// be empty.
  GrblSegment next();
  /// Spans of the last prepared segment.
  const std::vector<GrblSpan>& spans() const { return spans_; }
  /// True if the profile of the front block is known; otherwise next() computes it.
  bool has_profile() const { return loaded_; }
  /// Speed up to which the front block is prepared, if it has begun [mm/min].
  std::optional<float> running_speed() const;
  /// Call after a GrblPlanner::add() that reached the front block.
  void begin_again() { loaded_ = false; }

 private:
  void load(GrblBlock& block);
  void plan_profile(const GrblBlock& block);
  float run_phase(const GrblBlock& block, float& left, float time);
  double timed(const GrblBlock& block, float left, float planned);

  const GrblSettings& settings_;
  GrblPlanner& planner_;
  std::vector<GrblSpan> spans_;
  bool begun_ = false;   ///< the front block already has segments
  bool loaded_ = false;  ///< its profile is known

  GrblPhase phase_ = GrblPhase::accelerates;
  float speed_ = 0;             ///< [mm/min]
  float top_speed_ = 0;         ///< [mm/min]
  float exit_speed_ = 0;        ///< [mm/min]
  float accelerate_until_ = 0;  ///< of the length left [mm]
  float brake_after_ = 0;       ///< of the length left [mm]
  float steps_per_mm_ = 0;      ///< of the axis with the most steps
  float least_advance_ = 0;     ///< of a segment [mm]
  float steps_left_ = 0;
  float time_left_ = 0;  ///< of the step left unfinished by the previous segment [min]
};

}  // namespace feedscope
