#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/models/ward/ward_settings.h"
#include "core/trajectory/filtered_corner.h"
#include "core/trajectory/length_walk.h"
#include "core/trajectory/stretch.h"

namespace feedscope {

/// Runs stretches from standstill to standstill, one after the other, into a trajectory: chooses the pulses
/// (ward_runner.cpp), lowers them until the contour tolerance is kept (ward_tolerance.cpp) and lays the
/// filtered motion out as elements, pieces and records (ward_motion.cpp).
class WardRunner {
 public:
  /// `smoothed`: a copy of `toolpath` whose points the compressor moves, stretch by stretch; null: it is not
  /// at work.
  WardRunner(std::shared_ptr<const Toolpath> toolpath, std::shared_ptr<Toolpath> smoothed,
             const AxisVectors& axes, const WardSettings& settings, const PathRules& rules,
             TrajectoryBuilder& builder);

  /// Lines and arcs without a stop between them. `steps` counts segments.
  void run(const StretchRange& range, ProgressSteps& steps);

 private:
  struct Span {
    double end = 0;  ///< of the motion [s]
    double q = 0;    ///< path length from the element's start [mm]
    Cause cause;
    bool settled = false;
  };
  /// Of a block's programmed points from the path [mm].
  struct BlockDistance {
    double corner = 0;  ///< its start
    double arc = 0;     ///< places inside an arc
    double largest() const { return std::max(corner, arc); }
  };
  struct SpanEnd {
    double time = 0;                                   ///< of the motion [s]
    std::optional<std::size_t> corner = std::nullopt;  ///< whose blending pulse fills the span, if one
    bool settled = false;
  };

  /// Moves the points of dense blocks onto the compressor's curves.
  void smooth_points(const StretchRange& range);
  void find_limits(const StretchRange& range);
  void choose_filter_time();
  void limit_arcs();
  void choose_corner_speeds();

  /// Lowers corner speeds, and feeds on arcs, until every corner and every arc keeps the tolerance.
  void enforce_tolerance(ProgressSteps& steps);
  /// Lowers those that are due for a look and too far from the path; unless `every`, only those that the pass
  /// before lowered. True if any was.
  bool lower_blocks(int pass, bool every, ProgressSteps& steps);
  bool lower_corner(std::size_t block, double distance, int pass);
  bool lower_arc(std::size_t block, double distance, int pass);
  void mark_neighbours();
  /// Calls f(point, time) for programmed points inside the arc that `block` is: every `step` [s] from its
  /// ends up to `reach`, and in its middle; `time` is when the path is about there [s].
  template <typename F>
  void for_points_of_arc(std::size_t block, double step, double reach, F f) const;
  double distance_of_arc(std::size_t block);
  /// Distance of a point from the path near `time` [mm]: by one evaluation and its Newton step where that is
  /// precise, which it mostly is because the path lags as much as at the point before.
  double distance_of(const Vec3& point, double time, double tolerance);
  /// Contour tolerance at the start of a block, > 0, and inside an arc; infinite for an arc of tolerance 0,
  /// which no filtered motion keeps [mm].
  double corner_tolerance(std::size_t block) const {
    return rules_.corner_tolerance(train_.first + block - 1);
  }
  double arc_tolerance(std::size_t block) const;
  BlockDistance distance_of_block(std::size_t block);
  void measure_distances();
  bool is_arc(std::size_t block) const { return train_.segment(block).kind == SegmentKind::arc; }

  void lay_motion(ProgressSteps& steps);
  void add_element(double start, std::size_t block);
  void add_spans(LengthWalk& length, std::size_t block);
  void add_span(LengthWalk& length, std::size_t block, const SpanEnd& to);
  /// Why the tool is not faster at an instant of `block`. `corner`: whose blending pulse that is, if one.
  Cause cause_at(const SpeedSample& at, std::size_t block, std::optional<std::size_t> corner) const;
  /// Share of the speed limit on an arc that the filters leave of a pulse.
  double arc_gain(std::size_t block) const;
  bool slowed_by_tolerance(std::size_t corner) const;

  std::shared_ptr<const Toolpath> programmed_;
  std::shared_ptr<Toolpath> smoothed_;         ///< null: the compressor is not at work
  std::shared_ptr<const Toolpath> commanded_;  ///< one of these
  Compressor compressor_;
  AxisVectors axes_;
  WardSettings settings_;
  const PathRules& rules_;
  TrajectoryBuilder& builder_;

  PulseTrain train_;
  FilterWalk walk_;
  double lag_ = 0;  ///< of the path behind the middle of the filters at the point looked at last [s]
  std::vector<SpeedBound> limits_;     ///< of the feed, a block
  std::vector<double> corner_speeds_;  ///< at the start of every block, to be laid next [mm/s]
  std::vector<double> distance_;       ///< a block, when it was last looked at [mm]
  std::vector<char> check_;            ///< a block: due for a look, or lowered at the last one
  std::vector<char> slowed_;           ///< arcs whose feed this pass has lowered
  std::vector<Span> spans_;            ///< of the element under way
};

}  // namespace feedscope
