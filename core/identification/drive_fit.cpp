#include "core/identification/drive_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/identification/drive_record.h"

namespace feedscope {
namespace {

constexpr std::size_t parameter_count = 3;
constexpr std::size_t most_samples = 400'000;
constexpr std::size_t first_samples = 30'000;  // for the first look
constexpr double least_reach = 0.5;            // [mm] that the axis must move
constexpr double most_left = 1.0 / 3;          // of the following error
constexpr double lasting = 12;                 // change of the sum of squares that is more than noise
constexpr double told_deviations = 2;          // standard deviations
constexpr double coarsest_value = 0.2;         // share of a value beyond which its uncertainty is no answer
constexpr double coarsest_share = 0.05;        // the same of the feed-forward, which is a share itself
constexpr std::array least_error{2e-3, 2e-3,
                                 1e-2};     // shares, of the feed-forward absolute: never claimed less
constexpr std::size_t left_out_parts = 12;  // of the samples, that are left out in turn
constexpr double place_step = 1e-3;         // for derivatives

constexpr double noticed = 3e-5;        // [mm] left over by a simpler drive, beside a share
constexpr double noticed_share = 3e-4;  // of the following error: the set position between samples is a guess
constexpr double least_gain = 1;        // [1/s]
constexpr double most_gain = 3000;      // [1/s]
constexpr double most_lag = 0.1;        // [s]
constexpr double least_lag = 1e-3;      // [ms]: as good as none

constexpr const char* reason_unrecorded =
    QT_TRANSLATE_NOOP("core", "No trace has both the set and the actual position of the axis.");
constexpr const char* reason_stands = QT_TRANSLATE_NOOP("core", "The axis hardly moves in these traces.");
constexpr const char* reason_follows = QT_TRANSLATE_NOOP(
    "core", "Set and actual positions do not differ by more than noise: no following error tells it.");
constexpr const char* reason_unexplained = QT_TRANSLATE_NOOP(
    "core",
    "A linear drive leaves more than a third of the following error unexplained: friction, elasticity, or "
    "positions that were not recorded at the same time.");
constexpr const char* reason_smaller =
    QT_TRANSLATE_NOOP("core", "These traces show the same with smaller values.");
constexpr const char* reason_not_apart =
    QT_TRANSLATE_NOOP("core", "It cannot be told apart from the others by these traces.");

/// Logarithm of the gain [1/s], feed-forward, lag [ms].
using Place = Eigen::Vector3d;

const Place& least_place() {
  static const Place least(std::log(least_gain), 0, 0);
  return least;
}

const Place& most_place() {
  static const Place most(std::log(most_gain), 1, units::to_ms(most_lag));
  return most;
}

AxisDrive drive_at(const Place& place) {
  const Place inside = place.cwiseMax(least_place()).cwiseMin(most_place());
  AxisDrive drive;
  drive.gain = std::exp(inside[0]);
  drive.feedforward = inside[1];
  drive.lag = units::from_ms(inside[2]);
  return drive;
}

using Free = std::array<bool, parameter_count>;

/// Looks for the drive that explains a record best.
class DriveSearch {
 public:
  explicit DriveSearch(const DriveRecord& record, Progress* progress)
      : record_(record), progress_(progress) {}

  Eigen::VectorXd residuals(const Place& place) const {
    if (progress_ != nullptr && progress_->cancelled()) {
      throw Cancelled();
    }
    return record_.residuals(drive_at(place));
  }
  double cost(const Place& place) const { return residuals(place).squaredNorm(); }

  /// By the numbers that are `free`.
  Eigen::MatrixXd slopes(const Place& place, const Free& free) const {
    const Place inside = place.cwiseMax(least_place()).cwiseMin(most_place());
    Eigen::MatrixXd found(static_cast<Eigen::Index>(record_.size()), std::ranges::count(free, true));
    Eigen::Index column = 0;
    for (Eigen::Index p = 0; p < inside.size(); ++p) {
      if (free[static_cast<std::size_t>(p)]) {
        Place above = inside;
        Place below = inside;
        above[p] = std::min(inside[p] + place_step, most_place()[p]);
        below[p] = std::max(inside[p] - place_step, least_place()[p]);
        found.col(column++) = (residuals(above) - residuals(below)) / (above[p] - below[p]);
      }
    }
    return found;
  }

  /// Numbers that are `free` change from `start` on, so that the sum of squares becomes least.
  Place refined(const Place& start, const Free& free, int most) const;

 private:
  const DriveRecord& record_;
  Progress* progress_;
};

/// The task as Eigen's Levenberg-Marquardt asks for it.
class DriveTask {
 public:
  DriveTask(const DriveSearch& search, const Place& start, const Free& free, Eigen::Index count)
      : search_(search), start_(start), free_(free), count_(count) {}

  Eigen::Index values() const { return count_; }
  int operator()(const Eigen::VectorXd& at, Eigen::VectorXd& residuals) const {
    residuals = search_.residuals(place_of(at));
    return 0;
  }
  int df(const Eigen::VectorXd& at, Eigen::MatrixXd& slopes) const {
    slopes = search_.slopes(place_of(at), free_);
    return 0;
  }
  Place place_of(const Eigen::VectorXd& at) const {
    Place place = start_;
    Eigen::Index next = 0;
    for (Eigen::Index p = 0; p < place.size(); ++p) {
      if (free_[static_cast<std::size_t>(p)]) {
        place[p] = at[next++];
      }
    }
    return place;
  }
  Eigen::VectorXd free_part() const {
    Eigen::VectorXd part(std::ranges::count(free_, true));
    Eigen::Index next = 0;
    for (Eigen::Index p = 0; p < start_.size(); ++p) {
      if (free_[static_cast<std::size_t>(p)]) {
        part[next++] = start_[p];
      }
    }
    return part;
  }

 private:
  const DriveSearch& search_;
  Place start_;
  Free free_;
  Eigen::Index count_;
};

Place DriveSearch::refined(const Place& start, const Free& free, int most) const {
  // A number that steps beyond a bound stays there: it is held, and the others are looked for again.
  Place at = start;
  Free left = free;
  for (std::size_t held = 0; held < parameter_count; ++held) {
    DriveTask task(*this, at, left, static_cast<Eigen::Index>(record_.size()));
    Eigen::LevenbergMarquardt<DriveTask> search(task);
    search.parameters.maxfev = most;
    search.parameters.xtol = 1e-9;
    search.parameters.ftol = 1e-12;
    Eigen::VectorXd part = task.free_part();
    search.minimize(part);
    const Place found = task.place_of(part);
    at = found.cwiseMax(least_place()).cwiseMin(most_place());
    bool beyond = false;
    for (std::size_t p = 0; p < parameter_count; ++p) {
      const auto i = static_cast<Eigen::Index>(p);
      beyond = beyond || (left[p] && at[i] != found[i]);
      left[p] = left[p] && at[i] == found[i];
    }
    if (!beyond || std::ranges::none_of(left, [](bool is_free) { return is_free; })) {
      break;
    }
  }
  return at;
}

/// The best of a grid over all that drives can be, a few of them refined.
Place first_guess(const DriveRecord& record, Progress* progress) {
  constexpr std::size_t gains = 16;
  constexpr std::size_t refined_ones = 4;
  constexpr int most = 60;
  constexpr std::array feedforwards{0.0, 0.4, 0.7, 0.9, 1.0};
  constexpr std::array lags{0.0, 1.0, 3.0, 8.0, 20.0};  // [ms]
  std::vector<Place> places;
  for (std::size_t i = 0; i < gains; ++i) {
    const double share = static_cast<double>(i) / (gains - 1);
    const double gain = std::lerp(std::log(4.0), std::log(800.0), share);
    for (const double feedforward : feedforwards) {
      for (const double lag : lags) {
        places.emplace_back(gain, feedforward, lag);
      }
    }
  }
  const DriveSearch search(record, progress);
  std::vector<std::pair<double, std::size_t>> costs(places.size());
  in_parallel(places.size(), [&](std::size_t i) { costs[i] = {search.cost(places[i]), i}; });
  std::ranges::partial_sort(costs, costs.begin() + refined_ones);
  std::vector<Place> best;
  for (std::size_t i = 0; i < refined_ones; ++i) {
    best.push_back(search.refined(places[costs[i].second], {true, true, true}, most));
  }
  return *std::ranges::min_element(best, {}, [&](const Place& place) { return search.cost(place); });
}

/// How many independent residuals there are, those one after the other being correlated.
double independent(const Eigen::VectorXd& residuals) {
  constexpr double most_correlated = 0.9999;
  const Eigen::Index n = residuals.size();
  const double square = residuals.squaredNorm();
  const double next = residuals.head(n - 1).dot(residuals.tail(n - 1));
  const double correlation = square > 0 ? std::clamp(next / square, 0.0, most_correlated) : 0;
  return std::max(1.0, static_cast<double>(n) * (1 - correlation) / (1 + correlation));
}

/// Standard deviations of the numbers of a place that are free; infinite where they show nothing.
std::array<double, parameter_count> deviations_of(const DriveSearch& search, const Place& place,
                                                  const Free& free) {
  std::array<double, parameter_count> found{};
  std::vector<Eigen::Index> used;
  for (std::size_t p = 0; p < parameter_count; ++p) {
    if (free[p]) {
      used.push_back(static_cast<Eigen::Index>(p));
    }
  }
  const Eigen::VectorXd residuals = search.residuals(place);
  const auto count = static_cast<Eigen::Index>(used.size());
  const Eigen::MatrixXd slopes = search.slopes(place, free);
  const Eigen::MatrixXd square = slopes.transpose() * slopes;
  const Eigen::LDLT<Eigen::MatrixXd> whole(square);
  const double rows = static_cast<double>(residuals.size());
  const double noise = residuals.squaredNorm() / rows * rows / independent(residuals);
  const Eigen::MatrixXd inverse = whole.solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::MatrixXd shifts(count, static_cast<Eigen::Index>(left_out_parts));
  for (std::size_t part = 0; part < left_out_parts; ++part) {
    const auto first =
        static_cast<Eigen::Index>(part * static_cast<std::size_t>(residuals.size()) / left_out_parts);
    const auto last =
        static_cast<Eigen::Index>((part + 1) * static_cast<std::size_t>(residuals.size()) / left_out_parts);
    const auto rows_of = slopes.middleRows(first, last - first);
    const Eigen::VectorXd pull = rows_of.transpose() * residuals.segment(first, last - first);
    const Eigen::MatrixXd rest = square - rows_of.transpose() * rows_of;
    shifts.col(static_cast<Eigen::Index>(part)) =
        (rest + 1e-12 * square.trace() * Eigen::MatrixXd::Identity(count, count)).ldlt().solve(pull);
  }
  const Eigen::VectorXd mean = shifts.rowwise().mean();
  for (Eigen::Index k = 0; k < count; ++k) {
    const double formal = std::sqrt(std::max(0.0, noise * inverse(k, k)));
    const double left_out =
        std::sqrt((static_cast<double>(left_out_parts) - 1) / static_cast<double>(left_out_parts) *
                  (shifts.row(k).array() - mean[k]).square().sum());
    const double larger = std::max(formal, left_out);
    found[static_cast<std::size_t>(used[static_cast<std::size_t>(k)])] =
        std::isfinite(larger) ? larger : std::numeric_limits<double>::infinity();
  }
  return found;
}

double root_mean_square(const Eigen::VectorXd& values) {
  return values.size() > 0 ? std::sqrt(values.squaredNorm() / static_cast<double>(values.size())) : 0;
}

/// What nothing is told of, and why.
void leave(DriveFit& fit, const char* reason) {
  for (IdentifiedParameter& one : fit.parameters) {
    one.value = one.start;
    one.reason = reason;
  }
}

/// Without lag, without feed-forward or without both, where that explains the record as well.
struct Simplest {
  Place place;
  Free free{true, true, true};
};

Simplest simplest(const DriveSearch& search, const Place& best, double following_error) {
  constexpr int most = 80;
  const Eigen::VectorXd residuals = search.residuals(best);
  const double cost = residuals.squaredNorm();
  const double tolerable = noticed + noticed_share * following_error;
  const double allowed = std::max(cost * (1 + lasting / independent(residuals)),
                                  static_cast<double>(residuals.size()) * tolerable * tolerable);
  for (const Free& free :
       {std::array{true, false, false}, std::array{true, true, false}, std::array{true, false, true}}) {
    Place start = best;
    start[1] = free[1] ? start[1] : 0;
    start[2] = free[2] ? start[2] : 0;
    const Place found = search.refined(start, free, most);
    if (search.cost(found) <= allowed) {
      return {found, free};
    }
  }
  return {best, {true, true, true}};
}

}  // namespace

std::string axes_with_drives(const std::vector<const Trace*>& traces) {
  std::string axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::ranges::any_of(traces, [&](const Trace* trace) { return trace->has_drive(axis); })) {
      axes += static_cast<char>('X' + axis);
    }
  }
  return axes;
}

DriveFit fit_drive(const std::vector<const Trace*>& traces, char axis, const AxisDrive& start,
                   Progress* progress) {
  DriveFit fit;
  fit.axis = axis;
  for (std::size_t p = 0; p < parameter_count; ++p) {
    fit.parameters[p].parameter = drive_parameter(axis, p);
    const SettingValue value = drive_value(start, p);
    const double* number = std::get_if<double>(&value);
    fit.parameters[p].start = number != nullptr ? *number : 0;
  }
  const auto index = static_cast<std::size_t>(axis - 'X');
  const DriveRecord record(traces, index, most_samples, progress);
  fit.samples = record.size();
  constexpr std::size_t least_samples = 200;
  if (record.size() < least_samples || record.reach() < least_reach) {
    leave(fit, axes_with_drives(traces).find(axis) == std::string::npos ? reason_unrecorded : reason_stands);
    return fit;
  }
  fit.following_error = root_mean_square(record.following_errors());
  const Place guess = first_guess(DriveRecord(traces, index, first_samples, progress), progress);
  const DriveSearch search(record, progress);
  constexpr int most = 200;
  const Place best = search.refined(guess, {true, true, true}, most);
  const Simplest found = simplest(search, best, fit.following_error);
  fit.left = root_mean_square(record.residuals(drive_at(found.place)));
  fit.explains = fit.left <= most_left * fit.following_error;
  if (!fit.explains) {
    constexpr double noise = 2e-3;  // [mm]: steps of encoders
    leave(fit, fit.following_error <= noise ? reason_follows : reason_unexplained);
    return fit;
  }
  const AxisDrive drive = drive_at(found.place);
  const std::array<double, parameter_count> deviation = deviations_of(search, found.place, found.free);
  for (std::size_t p = 0; p < parameter_count; ++p) {
    IdentifiedParameter& one = fit.parameters[p];
    const bool is_share = p == 1;
    const double value = is_share ? *drive.feedforward : p == 0 ? *drive.gain : units::to_ms(*drive.lag);
    // The logarithm of the gain is looked for, the others as they are.
    const double scale = p == 2 ? std::max(value, least_lag) : 1;
    one.value = value;
    const double share = std::hypot(told_deviations * deviation[p] / scale, least_error[p]);
    one.told = found.free[p] && share <= (is_share ? coarsest_share : coarsest_value);
    if (one.told) {
      one.uncertainty = is_share ? share : share * value;
    } else {
      one.reason = found.free[p] ? reason_not_apart : reason_smaller;
    }
  }
  return fit;
}

AxisDrive found_drive(const DriveFit& fit, const AxisDrive& start) {
  AxisDrive drive = start;
  if (!fit.explains) {
    return drive;
  }
  for (std::size_t p = 0; p < parameter_count; ++p) {
    const double value = fit.parameters[p].value;
    set_drive_value(drive, p, value > 0 || p == 0 ? SettingValue(value) : SettingValue(std::string()));
  }
  return drive;
}

}  // namespace feedscope
