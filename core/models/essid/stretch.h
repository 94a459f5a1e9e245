#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/feed/node_plan.h"
#include "core/models/essid/blend_law.h"
#include "core/models/essid/essid_settings.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

enum class JunctionKind : std::uint8_t { pass, blend, stop };

/// How the path goes on from segment i - 1 to segment i, both of them lines or arcs: straight or tangent
/// (pass), a corner of two lines (blend), a reversal or a corner that touches an arc (stop).
JunctionKind junction_kind(const Toolpath& toolpath, std::size_t i);

/// Runs stretches of segments from standstill to standstill, one after the other, into a trajectory.
class StretchRunner {
 public:
  StretchRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
                TrajectoryBuilder& builder);

  /// Segments [first, last): lines and arcs without a stop between them.
  void run(std::size_t first, std::size_t last, Progress* progress);

 private:
  struct Blend {
    BlendShape shape;
    SpeedBound feed;     ///< the lower of the two blocks'
    std::size_t record;  ///< in the builder
    double turn;         ///< [rad]
    double jerk;         ///< tangential, least along the blend [mm/s3]
  };
  /// What the planner and the motion need of a path element.
  struct Element {
    std::uint32_t index;      ///< in the path
    std::int32_t blend = -1;  ///< index into blends_
  };

  void lay_path(std::size_t first, std::size_t last);
  void add_straight(std::size_t segment, double cut_before, double cut_after);
  void add_blend(std::size_t corner, const Corner& corner_data, const Vec3& in, const Vec3& out);
  void set_junction_ceilings();
  /// Whether a blend is a level place of the plan, with one speed for both of its ends.
  bool is_level(const Blend& blend) const;
  void hold_level_blends();

  void move(const std::vector<PlanNode>& nodes, std::size_t count, std::size_t first_segment,
            Progress* progress);
  /// Tries the law of the paper on the blend behind node `n`; moves on to the node it returns if that works.
  std::optional<std::size_t> move_over_blend(const std::vector<PlanNode>& nodes, std::size_t n);
  void pass_level(std::size_t element);
  SpeedProfile profile_to(double target, const SpanLimits& span, double speed, double acceleration) const;
  void add_profile(const SpeedProfile& profile, const SpanLimits& span, std::size_t first, std::size_t last);
  void add_blend_steps(const BlendMotion& motion, std::size_t element);

  const Toolpath& toolpath_;
  AxisVectors axes_;
  BlendLimits blend_limits_;
  EssidSettings settings_;
  TrajectoryBuilder& builder_;

  std::vector<PlanElement> plan_;
  std::vector<Element> elements_;
  std::vector<Blend> blends_;
  std::vector<std::uint32_t> block_of_;
  std::vector<double> ceiling_;       ///< at junctions [mm/s]
  std::vector<std::uint32_t> level_;  ///< junctions that are nodes in any case
  double speed_ = 0;                  ///< at the current node [mm/s]
  double acceleration_ = 0;           ///< [mm/s2]
};

}  // namespace feedscope
