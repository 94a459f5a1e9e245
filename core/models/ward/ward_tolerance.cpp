#include "core/models/ward/ward_tolerance.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/models/ward/short_blocks.h"

namespace feedscope {
namespace {

// Where corners are dense their distance is proportional to the square of the speed. The later passes finish
// slow convergence, at the latest by a stop in the corner.
constexpr double aim = 0.98;
constexpr int careful_passes = 32;
constexpr int last_passes = 40;

// State of a block in check_. Most are settled after a few passes, but lie in the window of one that is not:
// only lowered ones are checked again at once, the others when these are settled.
constexpr char due = 1;
constexpr char lowered_last = 2;

double lowering_factor(double distance, double tolerance, int pass) {
  const double factor = std::sqrt(aim * tolerance / distance);
  return pass < careful_passes ? factor : std::min(factor, 0.5);
}

}  // namespace

WardTolerance::WardTolerance(WardPulses& pulses, const PathRules& rules, const Progress* progress)
    : pulses_(pulses),
      train_(pulses.train),
      rules_(rules),
      progress_(progress),
      distances_(train_.size()),
      check_(train_.size(), due),
      slowed_(train_.size(), 0) {}

void WardTolerance::enforce(ProgressSteps& steps) {
  bool every = true;
  for (int pass = 0;; ++pass) {
    if (lower_blocks(pass, every, steps)) {
      cap_by_short_blocks(train_, pulses_.corner_speeds);
      mark_neighbours();
      lay_pulses(train_, pulses_.limits, pulses_.corner_speeds);
      every = false;
    } else if (every) {
      return;
    } else {
      every = true;
    }
  }
}

void WardTolerance::measure() {
  look(due);
}

double WardTolerance::largest() const {
  double largest = 0;
  for (const BlockDistance& distance : distances_) {
    largest = std::max(largest, distance.largest());
  }
  return largest;
}

void WardTolerance::look(char wanted) {
  constexpr std::size_t part_size = 4096;  // blocks; the result does not depend on the number of threads
  const std::size_t count = train_.size();
  in_parallel((count + part_size - 1) / part_size, [&](std::size_t part) {
    BlockDistances distances(pulses_, rules_);
    for (std::size_t i = part * part_size; i < std::min((part + 1) * part_size, count); ++i) {
      if ((check_[i] & wanted) == wanted) {
        stop_if_cancelled(progress_);
        distances_[i] = distances.of(i);
      }
    }
  });
}

bool WardTolerance::lower_blocks(int pass, bool every, ProgressSteps& steps) {
  steps.at(train_.first);
  const char wanted = every ? due : due | lowered_last;
  look(wanted);
  bool any = false;
  for (std::size_t i = 0; i < train_.size(); ++i) {
    if ((check_[i] & wanted) == wanted) {
      const bool corner = lower_corner(i, distances_[i].corner, pass);
      const bool arc = lower_arc(i, distances_[i].arc, pass);
      check_[i] = corner || arc ? lowered_last : 0;
      any = any || corner || arc;
    }
  }
  return any;
}

bool WardTolerance::lower_corner(std::size_t block, double distance, int pass) {
  if (block == 0 || pulses_.corner_speeds[block] == 0 ||
      !exceeds(distance, pulses_.corner_tolerance(rules_, block))) {
    return false;
  }
  pulses_.corner_speeds[block] *=
      pass < last_passes ? lowering_factor(distance, pulses_.corner_tolerance(rules_, block), pass) : 0;
  return true;
}

bool WardTolerance::lower_arc(std::size_t block, double distance, int pass) {
  const bool stops_after = block + 1 == train_.size() || pulses_.corner_speeds[block + 1] == 0;
  if (pulses_.corner_speeds[block] == 0 && stops_after && pass >= last_passes) {
    return false;  // a single corner between two stops keeps the tolerance by its limit
  }
  const double tolerance = pulses_.arc_tolerance(rules_, block);
  if (!exceeds(distance, tolerance)) {
    return false;
  }
  const double factor = lowering_factor(distance, tolerance, pass);
  pulses_.limits[block] = {factor * train_.blocks[block].feed, {CauseKind::contour_tolerance}};
  slowed_[block] = 1;
  const double end_speed = pass < last_passes ? pulses_.limits[block].value : 0;
  pulses_.corner_speeds[block] = std::min(pulses_.corner_speeds[block], end_speed);
  if (block + 1 < train_.size()) {
    pulses_.corner_speeds[block + 1] = std::min(pulses_.corner_speeds[block + 1], end_speed);
  }
  return true;
}

void WardTolerance::mark_neighbours() {
  const auto& blocks = train_.blocks;
  std::size_t unmarked = 0;
  for (std::size_t i = 0; i < train_.size(); ++i) {
    if (pulses_.corner_speeds[i] == blocks[i].corner_speed && !slowed_[i]) {
      continue;
    }
    // The pulses of this corner end within half of the delay; where its blocks are short their feeds change
    // too, from their other corners on.
    const double before = i > 0 ? std::max(blocks[i - 1].start, blocks[i].start - train_.delay()) : 0;
    const double after =
        slowed_[i] ? blocks[i + 1].start : std::min(blocks[i + 1].start, blocks[i].start + train_.delay());
    const double first = before - train_.delay();
    const double last = after + train_.delay();
    slowed_[i] = 0;
    for (std::size_t k = i; k > unmarked && blocks[k].start >= first; --k) {
      check_[k - 1] |= due;
    }
    std::size_t k = std::max(i, unmarked);
    for (; k < train_.size() && blocks[k].start <= last; ++k) {
      check_[k] |= due;
    }
    unmarked = k;
  }
}

}  // namespace feedscope
