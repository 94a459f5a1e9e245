#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/models/essid/blend_law.h"
#include "core/models/essid/essid_settings.h"
#include "core/toolpath/gentle_blend_length.h"
#include "core/trajectory/blended_stretch.h"

namespace feedscope {

/// Kind, transition and length of the blend in a corner. `gentle`: for the rule's weight.
CornerPiece lay_blend(const CornerPlace& place, const CornerRule& rule, const GentleBlendLength& gentle);

/// Runs stretches from standstill to standstill into a trajectory, one after the other: lays blends into
/// their corners, plans, and moves over lines by ramps and over blends by the paper's law.
class EssidRunner {
 public:
  EssidRunner(const Toolpath& toolpath, const AxisVectors& axes, const EssidSettings& settings,
              const PathRules& rules, const CompressorSettings& compressor, TrajectoryBuilder& builder);

  /// Lines and arcs without a stop between them. `steps` counts segments.
  void run(const StretchRange& range, ProgressSteps& steps);

 private:
  /// A blend of the path, computed again where it is run: most are passed within ramps.
  struct Blend {
    BlendShape shape;
    SpeedBound feed;  ///< the lower feed of the two blocks
    double turn;      ///< [rad]
  };

  void lay_path(const StretchRange& range);
  CornerPiece blend_corner(const CornerPlace& place, const StretchRange& range);
  void hold_turns_by_parameter(const BlendShape& shape, std::size_t segment, const StretchRange& range,
                               CornerPiece& piece) const;
  /// Makes blends that turn much level places of the plan, with one speed at both ends.
  void hold_level_blends();

  void plan_and_move(const StretchRange& range, ProgressSteps& steps);
  void move(const std::vector<PlanNode>& nodes, ProgressSteps& steps);
  /// Tries the law of the paper on the blend after node `n`; moves to the node it returns if that works.
  std::optional<std::size_t> move_over_blend(const std::vector<PlanNode>& nodes, std::size_t n);
  /// Passes a level blend, at constant speed if that keeps every limit, else at constant du/dt.
  void pass_level(std::size_t element);
  /// `slower_place`: cause of the speed of the node ahead.
  void add_blend_steps(const std::vector<BlendStep>& blend_steps, std::size_t element, Cause slower_place);
  bool is_blend(std::size_t element) const { return stretch_.blend[element] != 0; }
  Blend blend_of(std::size_t element) const;

  const Toolpath& toolpath_;
  GentleBlendLength gentle_length_;
  AxisVectors axes_;
  BlendLimits blend_limits_;
  EssidSettings settings_;
  const PathRules& rules_;
  Compressor compressor_;
  TrajectoryBuilder& builder_;

  Stretch stretch_;
  std::vector<std::uint8_t> turns_much_;  ///< per blend of the stretch: 1 if it turns by more than a level
                                          ///< place
  double speed_ = 0;                      ///< at the current node [mm/s]
};

}  // namespace feedscope
