#pragma once

#include "core/models/control_model.h"

namespace feedscope {

/// Velocity pulses smoothed by moving averages (FIR filters), as a Heidenhain TNC 640 interpolates.
///
/// R. Ward, B. Sencer, B. Jones, E. Ozturk, "Accurate prediction of machining feedrate and cycle times
/// considering interpolator dynamics", Int J Adv Manuf Technol (2021); equations in README.md in this
/// folder. Symbols: n filters of length T1, delay T_d = n T1, F feed, a blending factor, V_c = a F height of
/// the blending pulses, T_b = (T_d/2)(1 - a) their width on each side of a corner, T_v width of the pulse
/// between.
///
/// Departures from print: corner_pulse.h (eq 29, 30, 38-42); T_v takes both blending pulses off, with their
/// own heights (eq 22 lacks a term); V_c is the height of the pulse, not the corner speed (eq 12 is not
/// exact). Beyond the paper:
///  - T1 is a constant of the machine where its file gives one (filter_time_s; README.md gives its
///    basis). Otherwise it is one from stop to stop, from the largest programmed feed of that part.
///  - Blocks too short for their blending pulses: short_blocks.h; V_c and T_b are computed again with the
///    lowered feed until both settle.
///  - `enforce`: where several corners lie within one filter window the isolated formula exceeds the
///    tolerance; their pulses are lowered until the distance of every corner from the path keeps it. As a
///    last resort the control stops in the corner.
///  - Arcs and helices are commanded as pulses that turn, not faster than the static limits of
///  segment_limits.h
///    and, where the tolerance is enforced, than arc_speed() of corner_pulse.h; a few points on each are
///    watched as corners are.
class WardModel : public ControlModel {
 public:
  const ModelInfo& info() const override;
  Guarantees guarantees(const Settings& settings) const override;

 private:
  Trajectory do_simulate(const std::shared_ptr<const Toolpath>& toolpath, const Machine& machine,
                         const Settings& settings, Progress* progress) const override;
  Explanation do_explain(const SimulatedMotion& motion, const State& state) const override;
};

}  // namespace feedscope
