#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/blend/junction.h"
#include "core/limits/segment_limits.h"
#include "tests/contract/checks.h"

namespace feedscope::contract {
namespace {

/// Those of a list by segment that are in [first, last), counted from `first`.
template <typename Item>
std::vector<Item> items_of(const std::vector<Item>& items, std::size_t first, std::size_t last) {
  std::vector<Item> found;
  for (Item item : items) {
    if (item.segment >= first && item.segment < last) {
      item.segment -= first;
      found.push_back(item);
    }
  }
  return found;
}

/// Segments [first, last) of `whole` as a path of their own.
Toolpath part_of(const Toolpath& whole, std::size_t first, std::size_t last) {
  Toolpath part = whole;
  part.start = whole.start_of(first);
  part.segments.assign(whole.segments.begin() + static_cast<std::ptrdiff_t>(first),
                       whole.segments.begin() + static_cast<std::ptrdiff_t>(last));
  part.segment_turns = items_of(whole.segment_turns, first, last);
  part.turn_joints = items_of(whole.turn_joints, first, last);
  part.turn_parts = items_of(whole.turn_parts, first, last);
  part.rotary_turns = items_of(whole.rotary_turns, first, last);
  return part;
}

/// Where every model may be cut: what it promises to be a standstill, and what is one to a model without any.
bool can_be_cut(const Toolpath& toolpath, std::size_t i, const Guarantees& promised) {
  switch (junction_kind(toolpath, i)) {
    case JunctionKind::stop:
      return true;
    case JunctionKind::corner:
      return promised.stops_at_line_corners;
    case JunctionKind::arc_corner:
      return promised.stops_at_arc_corners;
    case JunctionKind::pass:
      break;
  }
  return false;
}

Result compare(const Trajectory& whole, double from, const Trajectory& part, double to, std::uint32_t line) {
  const double clock = 1e-9 * (1 + whole.duration());
  if (!(std::abs(to - from - part.duration()) <= clock)) {
    return Finding{"split", fmt::format("at the end of line {}: {} s of the whole program, {} s alone", line,
                                        to - from, part.duration())};
  }
  for (const double share : {0.11, 0.37, 0.5, 0.83}) {
    const double time = share * part.duration();
    const State a = whole.state(from + time);
    const State b = part.state(time);
    const double off = (a.position - b.position).norm();
    const double change = (a.speed + b.speed) * clock;
    if (!(off <= 1e-8 + change)) {
      return Finding{"split",
                     fmt::format("at the end of line {}: states {} s on are {} mm apart", line, time, off)};
    }
  }
  return {};
}

}  // namespace

Result check_again(const Motion& motion, const Inputs& inputs) {
  const Trajectory again = inputs.model.simulate(inputs.programmed, inputs.machine, inputs.settings);
  return same_bits(motion.run(), again) ? Result() : Finding{"again", "another result when run again"};
}

Result check_split(const Motion& motion, const Guarantees& promised, const Inputs& inputs) {
  constexpr std::size_t max_cuts = 3;  // of a program
  const Toolpath& toolpath = motion.toolpath();
  std::vector<std::size_t> places;
  if (!promised.begins_again_at_stops) {
    return {};
  }
  for (std::size_t i = 1; i < toolpath.segments.size(); ++i) {
    if (can_be_cut(toolpath, i, promised)) {
      places.push_back(i);
    }
  }
  const std::size_t step = 1 + places.size() / max_cuts;
  for (std::size_t k = places.size() % step; k < places.size(); k += step) {
    const std::size_t i = places[k];
    const std::size_t part = motion.first_part_of(i);
    const double cut = part < motion.parts().size() ? motion.parts()[part].time : motion.run().duration();
    const std::uint32_t line = toolpath.segments[i - 1].line;
    const auto run = [&](std::size_t first, std::size_t last) {
      const MachinePath path{std::make_shared<const Toolpath>(part_of(toolpath, first, last)), {}};
      return inputs.model.simulate(path, inputs.machine, inputs.settings);
    };
    if (Result wrong = compare(motion.run(), 0, run(0, i), cut, line)) {
      return wrong;
    }
    if (Result wrong =
            compare(motion.run(), cut, run(i, toolpath.segments.size()), motion.run().duration(), line)) {
      return wrong;
    }
  }
  return {};
}

namespace {

/// What times must grow by for the motion to keep programmed feed, velocity and acceleration; at least 1.
double slower_by(const Motion& motion, const AxisVectors& axes) {
  double factor = 1;
  for (const Part& part : motion.parts()) {
    if (part.place == Place::dwell) {
      continue;
    }
    constexpr int samples = 8;
    for (int k = 0; k <= samples; ++k) {
      const State s = motion.at(part, static_cast<double>(k) / samples);
      factor = std::max({factor, s.speed / s.programmed_feed,
                         s.velocity.cwiseAbs().cwiseQuotient(axes.velocity).maxCoeff(),
                         std::sqrt(s.acceleration.cwiseAbs().cwiseQuotient(axes.acceleration).maxCoeff())});
    }
  }
  return factor;
}

/// Settings of the bound on the path of the model of `inputs`.
Settings settings_of_bound(const ControlModel& bound, const Inputs& inputs) {
  Settings settings = complete_settings(bound, inputs.machine);
  for (const auto& [key, value] : inputs.settings.values()) {
    settings.set(key, value);
  }
  settings.set("path", inputs.model.info().id);
  settings.set("jerk", std::string("off"));
  return settings;
}

bool has_path(const ControlModel& bound, const std::string& id) {
  const std::vector<SettingSpec>& specs = bound.info().settings;
  const auto path = std::find_if(specs.begin(), specs.end(), [](const auto& s) { return s.key == "path"; });
  return std::find(path->choices.begin(), path->choices.end(), id) != path->choices.end();
}

}  // namespace

Result check_bound(const Motion& motion, const Guarantees& promised, const Inputs& inputs) {
  const ControlModel& bound = find_model("optimal");
  if (promised.continuity == Continuity::position || !has_path(bound, inputs.model.info().id)) {
    return {};
  }
  if (!motion.run().motions().empty()) {  // on random programs a filtered path can take gigabytes to lay anew
    return {};
  }
  constexpr double grid = 1e-3;  // of its time: what cells of half the length change at most
  const double least =
      bound.simulate(inputs.programmed, inputs.machine, settings_of_bound(bound, inputs)).duration();
  const double factor = slower_by(motion, AxisVectors(inputs.machine));
  if (!(least <= motion.run().duration() * factor * (1 + grid))) {
    return Finding{"bound",
                   fmt::format("{} s, passed {} times as slow to keep feed, velocity and acceleration; "
                               "the bound is {} s",
                               motion.run().duration(), factor, least)};
  }
  return {};
}

}  // namespace feedscope::contract
