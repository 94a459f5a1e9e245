#include "core/analysis/run/summary.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/analysis/contour/corner_distance.h"
#include "core/analysis/run/peak_search.h"
#include "core/analysis/time/programmed_time.h"
#include "core/base/exact_sum.h"
#include "core/base/parallel.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

/// Sums over the pieces of a trajectory.
class Totals {
 public:
  explicit Totals(const Trajectory& trajectory)
      : trajectory_(trajectory), by_cause_(all_causes().size()), by_slower_place_(all_causes().size()) {}

  /// Adds pieces [first, last).
  void add_pieces(std::size_t first, std::size_t last) {
    for (PartWalk walk(trajectory_, first); !walk.done() && walk.part().piece < last; walk.next()) {
      const Part& part = walk.part();
      by_cause_[cause_index(part.cause)].add(part.duration);
      if (part.cause.kind == CauseKind::ramp_down) {
        by_slower_place_[cause_index(trajectory_.slower_place(part.piece))].add(part.duration);
      }
      if (trajectory_.path().kind(part.element) == ElementKind::dwell) {
        waiting_.add(part.duration);
      }
      peaks_.add(trajectory_, part);
    }
  }

  void add(const Totals& other) {
    peaks_.add(other.peaks_);
    for (std::size_t i = 0; i < by_cause_.size(); ++i) {
      by_cause_[i].add(other.by_cause_[i]);
      by_slower_place_[i].add(other.by_slower_place_[i]);
    }
    waiting_.add(other.waiting_);
  }

  const PeakSearch& peaks() const { return peaks_; }
  double waiting() const { return waiting_.value(); }  ///< [s]
  std::vector<double> time_by_cause() const { return times(by_cause_); }
  std::vector<double> time_by_slower_place() const { return times(by_slower_place_); }

 private:
  std::vector<double> times(const std::vector<ExactSum>& sums) const {
    const double rounding = 1e-14 * trajectory_.duration();  // overlap of pieces that end where others begin
    std::vector<double> seconds;
    for (const ExactSum& sum : sums) {
      seconds.push_back(sum.value() < rounding ? 0 : sum.value());
    }
    return seconds;
  }

  const Trajectory& trajectory_;
  PeakSearch peaks_;
  std::vector<ExactSum> by_cause_;
  std::vector<ExactSum> by_slower_place_;
  ExactSum waiting_;
};

/// Adds up the pieces in runs whose length does not depend on the number of processors, on all processors;
/// calls `also` meanwhile.
Totals totals_of(const Trajectory& trajectory, const std::function<void()>& also, const Progress* progress) {
  constexpr std::size_t pieces_a_run = 16384;
  const std::size_t pieces = trajectory.pieces().size();
  const std::size_t runs = (pieces + pieces_a_run - 1) / pieces_a_run;
  std::vector<Totals> totals(std::max<std::size_t>(runs, 1), Totals(trajectory));
  in_parallel(runs + 1, [&](std::size_t i) {
    if (i == 0) {
      also();
    } else {
      stop_if_cancelled(progress);
      totals[i - 1].add_pieces((i - 1) * pieces_a_run, std::min(i * pieces_a_run, pieces));
    }
  });
  Totals sum = totals.front();
  for (std::size_t i = 1; i < runs; ++i) {
    sum.add(totals[i]);
  }
  return sum;
}

}  // namespace

Summary summarise(const Trajectory& trajectory, const Toolpath& toolpath, const Vec3& rapid_speed,
                  Progress* progress, bool limits_jerk) {
  Summary summary;
  summary.cycle_time = trajectory.duration();
  summary.programmed_time = programmed_time(toolpath, rapid_speed);
  summary.not_counted = not_counted(toolpath);

  ContourErrors errors;
  const auto measure = [&] {
    ContourRequest worst;
    worst.places = 1;
    errors = contour_errors(trajectory, worst, progress);
    summary.max_corner_distance = largest_corner_distance(trajectory, progress);
  };
  const Totals totals = totals_of(trajectory, measure, progress);
  summary.time_by_cause = totals.time_by_cause();
  summary.time_by_slower_place = totals.time_by_slower_place();
  summary.max_contour_error = errors.largest;
  summary.cutting_contour_error = cutting_contour_error(trajectory, errors, {}, progress);
  if (!errors.worst.empty()) {
    summary.worst_place = errors.worst.front();
  }
  const double moving = summary.cycle_time - totals.waiting();
  summary.mean_feed = moving > 0 ? trajectory.path_length() / moving : 0;
  summary.peak_feed = totals.peaks().speed();
  summary.axes = totals.peaks().axes(limits_jerk);
  return summary;
}

}  // namespace feedscope
