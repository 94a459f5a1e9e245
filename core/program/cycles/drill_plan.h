#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/path_writer.h"

namespace feedscope {

/// Feed of a step of a drilling cycle.
struct DrillFeed {
  double value = 0;  ///< as PathWriter::set_feed() in `mode`
  FeedMode mode = FeedMode::per_minute;
  double spindle_speed = 0;  ///< [1/s]; 0: as it is
};

struct DrillStep {
  enum class Kind : std::uint8_t { rapid, feed, dwell };
  Kind kind = Kind::rapid;
  double level = 0;               ///< end along the tool's axis, as programmed [mm]
  Vec3 aside = Vec3::Zero();      ///< end relative to the axis of the hole [mm]
  std::optional<DrillFeed> feed;  ///< none: as the program feeds
  double time = 0;                ///< dwell [s]
};

/// Motion of a drilling cycle at one hole, whatever its dialect, recorded step by step and then run at a
/// place.
class DrillPlan {
 public:
  /// `axis` of the tool, 0 to 2; `level`: position of the tool along it [mm].
  DrillPlan(int axis, double level) : axis_(axis), level_(level) {}

  int axis() const { return axis_; }
  /// End of the last step along the tool's axis [mm].
  double level() const { return level_; }
  const std::vector<DrillStep>& steps() const { return steps_; }

  void rapid(double level);
  void feed(double level, const std::optional<DrillFeed>& feed = std::nullopt);
  /// At rapid, by an offset across the tool's axis or along it [mm].
  void shift(const Vec3& by);
  /// Does nothing if `seconds` is not above 0.
  void dwell(double seconds);

 private:
  int axis_;
  double level_;
  Vec3 aside_ = Vec3::Zero();
  std::vector<DrillStep> steps_;
};

/// Runs a plan at the hole whose axis goes through `hole`. Skips rapids to the tool's position and restores
/// feed, feed mode and spindle speed. Calls `before` before each motion, with true for a rapid.
void run(const DrillPlan& plan, PathWriter& path, Vec3 hole,
         const std::function<void(bool rapid)>& before = {});

}  // namespace feedscope
