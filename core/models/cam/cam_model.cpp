#include "core/models/cam/cam_model.h"

#include "core/base/translatable.h"
#include "core/limits/segment_limits.h"
#include "core/models/explanation/explainer.h"
#include "core/trajectory/trajectory_builder.h"

namespace feedscope {

const ModelInfo& CamModel::info() const {
  static const ModelInfo info{
      "cam",
      QT_TRANSLATE_NOOP("core", "CAM baseline"),
      "",
      QT_TRANSLATE_NOOP("core",
                        "Path length divided by programmed feed, block by block; rapids at axis speed; "
                        "dwells as programmed: the time that a CAM system predicts."),
      {},
      {},
      {NC_("core", "A rapid keeps the velocity limit of every axis.")}};
  return info;
}

Guarantees CamModel::guarantees(const Settings&) const {
  Guarantees promised;
  promised.turning_velocity = 1.01;
  promised.turning_rapids_only = true;
  promised.continuity = Continuity::position;
  promised.limits_jerk = false;
  promised.stops_at_reversals = promised.stops_at_rapids = false;
  return promised;
}

Trajectory CamModel::do_simulate(const std::shared_ptr<const Toolpath>& shared, const Machine& machine,
                                 const Settings&, Progress* progress) const {
  const Toolpath& toolpath = *shared;
  const Vec3 velocity = axis_limit_vector(machine, &AxisLimits::velocity);
  TrajectoryBuilder builder(shared, velocity);
  builder.reserve(toolpath.segments.size(), toolpath.segments.size());
  ProgressSteps steps(progress, toolpath.segments.size());
  for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
    const Segment& segment = toolpath.segments[i];
    if (segment.kind == SegmentKind::dwell) {
      builder.add_pause(static_cast<std::uint32_t>(i));
    } else {
      const auto run = [&](const SpeedBound& speed, double length) {
        const std::uint32_t index = builder.add_segment(static_cast<std::uint32_t>(i), length);
        builder.add_piece({0, 0, speed.value, 0, 0, index, speed.cause}, length / speed.value);
      };
      if (segment.rapid) {
        for_turn_parts(toolpath, i, 0, segment.length, [&](const TurnPart* part, double from, double to) {
          run(feed_ceiling(toolpath, i, velocity, part), to - from);
        });
      } else {
        run(programmed_speed(toolpath, i, velocity), segment.length);
      }
    }
    steps.at(i);
  }
  return builder.finish();
}

Explanation CamModel::do_explain(const SimulatedMotion& motion, const State& state) const {
  return Explainer(motion, false).explain(state);
}

}  // namespace feedscope
