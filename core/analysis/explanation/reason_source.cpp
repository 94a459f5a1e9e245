#include "core/analysis/explanation/reason_source.h"

#include <algorithm>
#include <utility>

namespace feedscope {

std::string_view source_of(FormulaId id, const LimitTraits& traits) {
  const auto own = std::ranges::find(traits.sources, id, &LimitTraits::Source::formula);
  if (own != traits.sources.end()) {
    return own->text;
  }
  switch (id) {
    case FormulaId::none:
      return {};
    case FormulaId::programmed_feed:
      return "program";
    case FormulaId::axis_velocity:
      return "Tapie 2007, eq 7";
    case FormulaId::path_acceleration:
      return "Essid 2019, eq 24";
    case FormulaId::path_jerk:
      return "Tapie 2007, eq 9 and section 5.2.3";
    case FormulaId::braking_jerk:
      return "Tapie 2007, eq 16";
    case FormulaId::braking_acceleration:
      return "Tapie 2007, eq 16, with the acceleration limit";
    case FormulaId::acceleration_jump:
      return "BRISK of the program";
    case FormulaId::shared_acceleration:
      return "Essid 2019, eq 14 and 24";
    case FormulaId::shared_jerk:
    case FormulaId::jerk_across:
      return "Essid 2019, eq 15 and 24";
    case FormulaId::radial_acceleration:
      return "Tapie 2007, eq 2 and 8";
    case FormulaId::radial_jerk:
      return "Tapie 2007, eq 4 and 9";
    case FormulaId::shared_radial_acceleration:
    case FormulaId::shared_radial_jerk:
    case FormulaId::steady_acceleration:
    case FormulaId::steady_jerk:
      return "Essid 2019, eq 24 and 26";
    case FormulaId::curve_acceleration:
    case FormulaId::curve_jerk:
    case FormulaId::curve_ramp_acceleration:
    case FormulaId::curve_ramp_jerk:
      return "the compressor of Feedscope";
    case FormulaId::arc_blend_radial_jerk:
      return "Gassara 2013, in Essid 2019, section 4.3";
    case FormulaId::curvilinear_jerk:
      return "Tapie 2007, eq 10 and 11";
    case FormulaId::curvature_crossing:
      return "Tapie 2007, eq 13";
    case FormulaId::interpolation_period:
      return "Tapie 2007, eq 6";
    case FormulaId::horizon_jerk:
    case FormulaId::horizon_acceleration:
      return "Msaddek 2011, section 2.2.3";
    case FormulaId::filter_delay:
      return "Ward 2021, eq 8";
    case FormulaId::corner_error:
      return "Ward 2021, eq 25 to 30";
    case FormulaId::arc_error:
      return "Ward 2021, eq 1, on a circle";
    case FormulaId::block_time:
      return "one block each t_b";
    case FormulaId::junction_deviation:
    case FormulaId::square_corner:
    case FormulaId::corner_within_blocks:
    case FormulaId::stop_within_blocks:
    case FormulaId::braking_evenly:
    case FormulaId::path_velocity:
    case FormulaId::level_acceleration:
      return {};  // depends on the model
    case FormulaId::turning_velocity:
    case FormulaId::turning_acceleration:
    case FormulaId::turning_jerk:
    case FormulaId::turning_jump:
    case FormulaId::turning_ramp_acceleration:
    case FormulaId::turning_ramp_jerk:
    case FormulaId::turning_ramp_bend:
      return "chain rule over the kinematics of the machine";
    case FormulaId::whole_acceleration:
    case FormulaId::whole_jerk:
      return "Pham and Pham 2018";
  }
  return {};
}

Reason made_reason(const Trajectory& run, const ElementLimits& limits, Cause cause, Formula formula,
                   double reached, std::uint32_t element) {
  std::string source(source_of(formula.id, limits.traits()));
  return {cause, std::move(formula), reached, run.line_of(element), std::move(source)};
}

}  // namespace feedscope
