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
#include "core/identification/fit_parameter.h"

namespace feedscope {
namespace {

constexpr std::size_t most_samples = 400'000;
constexpr std::size_t first_samples = 30'000;  // for the first look
constexpr double least_reach = 0.5;            // [mm] that the axis must move
constexpr double most_left = 1.0 / 3;          // of the following error
constexpr double lasting = 12;                 // change of the sum of squares that is more than noise
constexpr double lasting_delay = 100;          // the same of delays, of which many are tried
constexpr double told_deviations = 2;          // standard deviations
constexpr double coarsest_value = 0.2;         // a larger share of the value as uncertainty: not told
constexpr double coarsest_share = 0.05;        // a larger uncertainty of the feed-forward: not told
/// Shares of gain and lag, of the feed-forward itself: less is never claimed.
constexpr std::array least_error{2e-3, 2e-3, 1e-2};
constexpr std::size_t left_out_parts = 12;  // of the record; each is omitted once
/// What the guess of the set position between samples leaves over, of one sign for long [mm], and as a share
/// of the following error.
constexpr double guessed = 2e-6;
constexpr double guessed_share = 1e-5;

constexpr double least_gain = 1;    // [1/s]
constexpr double most_gain = 3000;  // [1/s]
constexpr double most_lag = 100;    // [ms]
constexpr double place_step = 1e-3;

constexpr const char* reason_unrecorded =
    QT_TRANSLATE_NOOP("core", "No trace has both the set and the actual position of the axis.");
constexpr const char* reason_stands = QT_TRANSLATE_NOOP("core", "The axis hardly moves in these traces.");
constexpr const char* reason_follows = QT_TRANSLATE_NOOP(
    "core", "Set and actual positions do not differ by more than noise: no following error tells it.");
constexpr const char* reason_unexplained = QT_TRANSLATE_NOOP(
    "core",
    "A linear drive leaves more than a third of the following error unexplained: friction, elasticity, or "
    "positions that were not recorded at the same time.");
constexpr const char* reason_delayed =
    QT_TRANSLATE_NOOP("core",
                      "The positions go together better with a delay between set and actual ones than "
                      "without, which cannot be told "
                      "from a following error: record both in one cycle.");
constexpr const char* reason_beyond =
    QT_TRANSLATE_NOOP("core",
                      "The feed-forward would be outside 0 to 1: the positions were not recorded at the same "
                      "time, or the drive has "
                      "more than a linear loop.");
constexpr const char* reason_smaller =
    QT_TRANSLATE_NOOP("core", "These traces show the same with smaller values.");
constexpr const char* reason_not_apart =
    QT_TRANSLATE_NOOP("core", "It cannot be told apart from the others by these traces.");

/// Logarithm of the gain [1/s], feed-forward, lag [ms]. The feed-forward may leave 0 to 1 while it is looked
/// for.
using Place = Eigen::Vector3d;

AxisDrive drive_at(const Place& place) {
  AxisDrive drive;
  drive.gain = std::clamp(std::exp(place[0]), least_gain, most_gain);
  drive.feedforward = place[1];
  drive.lag = units::from_ms(std::clamp(place[2], 0.0, most_lag));
  return drive;
}

/// The task as Eigen's Levenberg-Marquardt asks for it: by the root of the lag, which is then never below 0.
class DriveTask {
 public:
  DriveTask(const DriveRecord& record, double delay, Progress* progress)
      : record_(record), delay_(delay), progress_(progress) {}

  static Eigen::VectorXd free_from(const Place& place) {
    return Place(place[0], place[1], std::sqrt(place[2]));
  }
  static Place place_from(const Eigen::VectorXd& free) {
    return {std::clamp(free[0], std::log(least_gain), std::log(most_gain)), free[1],
            std::min(free[2] * free[2], most_lag)};
  }

  Eigen::Index values() const { return static_cast<Eigen::Index>(record_.size()); }
  int operator()(const Eigen::VectorXd& at, Eigen::VectorXd& residuals) const {
    if (progress_ != nullptr && progress_->cancelled()) {
      throw Cancelled();
    }
    residuals = record_.residuals(drive_at(place_from(at)), delay_);
    return 0;
  }
  int df(const Eigen::VectorXd& at, Eigen::MatrixXd& slopes) const {
    Eigen::VectorXd above(at.size());
    Eigen::VectorXd below(at.size());
    for (Eigen::Index p = 0; p < at.size(); ++p) {
      Eigen::VectorXd moved = at;
      moved[p] = at[p] + place_step;
      (*this)(moved, above);
      moved[p] = at[p] - place_step;
      (*this)(moved, below);
      slopes.col(p) = (above - below) / (2 * place_step);
    }
    return 0;
  }

 private:
  const DriveRecord& record_;
  double delay_;
  Progress* progress_;
};

double cost_at(const DriveRecord& record, const Place& place) {
  return record.residuals(drive_at(place)).squaredNorm();
}

/// Where the sum of squares is least, from `start` on.
Place refined(const DriveRecord& record, const Place& start, int most, Progress* progress, double delay = 0) {
  DriveTask task(record, delay, progress);
  Eigen::LevenbergMarquardt<DriveTask> search(task);
  search.parameters.maxfev = most;
  search.parameters.xtol = 1e-9;
  search.parameters.ftol = 1e-12;
  Eigen::VectorXd at = DriveTask::free_from(start);
  search.minimize(at);
  return DriveTask::place_from(at);
}

/// Drives of all kinds that lag behind by `lag_time` at constant velocity [s], which the record tells at
/// once.
std::vector<Place> drives_that_lag(double lag_time) {
  constexpr std::array lags{0.1, 0.7, 2.0, 4.0, 8.0, 20.0};  // [ms]
  constexpr std::array feedforwards{0.0, 0.15, 0.3, 0.45, 0.6, 0.7, 0.8, 0.87, 0.93, 0.97, 0.99};
  constexpr std::array full_gains{5.0, 10.0, 20.0, 35.0, 60.0, 100.0, 170.0, 300.0};  // [1/s]
  std::vector<Place> places;
  for (const double lag : lags) {
    for (const double feedforward : feedforwards) {
      const double gain = (1 - feedforward) / std::max(lag_time, 1 / most_gain);
      places.emplace_back(std::log(std::clamp(gain, least_gain, most_gain)), feedforward, lag);
    }
    for (const double gain : full_gains) {
      places.emplace_back(std::log(gain), 1, lag);
    }
  }
  return places;
}

/// The best of many drives, a few of them, of different shares of feed-forward, refined.
Place first_guess(const DriveRecord& record, Progress* progress) {
  constexpr std::size_t refined_ones = 7;
  constexpr std::size_t most_of_a_share = 2;  // starts with one feed-forward
  constexpr int most = 60;
  const std::vector<Place> places = drives_that_lag(record.lag_time());
  std::vector<std::pair<double, std::size_t>> costs(places.size());
  in_parallel(places.size(), [&](std::size_t i) {
    if (progress != nullptr && progress->cancelled()) {
      throw Cancelled();
    }
    costs[i] = {cost_at(record, places[i]), i};
  });
  std::ranges::sort(costs);
  std::vector<Place> starts;
  for (const auto& [cost, i] : costs) {
    const auto same = std::ranges::count(starts, places[i][1], [](const Place& start) { return start[1]; });
    if (starts.size() < refined_ones && static_cast<std::size_t>(same) < most_of_a_share) {
      starts.push_back(places[i]);
    }
  }
  std::vector<Place> best(starts.size());
  in_parallel(starts.size(), [&](std::size_t i) { best[i] = refined(record, starts[i], most, progress); });
  return *std::ranges::min_element(best, {}, [&](const Place& place) { return cost_at(record, place); });
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

/// Residuals by the numbers of a place.
Eigen::MatrixXd slopes_at(const DriveRecord& record, const Place& place) {
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(record.size()), place.size());
  for (Eigen::Index p = 0; p < place.size(); ++p) {
    Place above = place;
    Place below = place;
    above[p] += place_step;
    below[p] = p == 2 ? std::max(0.0, place[p] - place_step) : place[p] - place_step;
    slopes.col(p) =
        (record.residuals(drive_at(above)) - record.residuals(drive_at(below))) / (above[p] - below[p]);
  }
  return slopes;
}

/// Standard deviations of the numbers of a place.
Place deviations_at(const DriveRecord& record, const Place& place, double following_error) {
  const Eigen::VectorXd residuals = record.residuals(drive_at(place));
  const Eigen::MatrixXd slopes = slopes_at(record, place);
  const Eigen::Matrix3d square = slopes.transpose() * slopes;
  const Eigen::Matrix3d inverse = square.ldlt().solve(Eigen::Matrix3d::Identity());
  const double guess = guessed + guessed_share * following_error;
  const double noise =
      std::max(residuals.squaredNorm() / independent(residuals),
               guess * guess * static_cast<double>(residuals.size()) / static_cast<double>(left_out_parts));
  Eigen::Matrix<double, 3, left_out_parts> shifts;
  for (std::size_t part = 0; part < left_out_parts; ++part) {
    const std::size_t size = record.size();
    const auto first = static_cast<Eigen::Index>(part * size / left_out_parts);
    const auto count = static_cast<Eigen::Index>((part + 1) * size / left_out_parts) - first;
    const auto rows = slopes.middleRows(first, count);
    const Eigen::Vector3d pull = rows.transpose() * residuals.segment(first, count);
    const Eigen::Matrix3d rest = square - rows.transpose() * rows;
    shifts.col(static_cast<Eigen::Index>(part)) =
        (rest + 1e-12 * square.trace() * Eigen::Matrix3d::Identity()).ldlt().solve(pull);
  }
  const Eigen::Vector3d mean = shifts.rowwise().mean();
  Place found;
  for (Eigen::Index p = 0; p < found.size(); ++p) {
    const double formal = std::sqrt(std::max(0.0, noise * inverse(p, p)));
    const double left_out =
        std::sqrt((left_out_parts - 1.0) / left_out_parts * (shifts.row(p).array() - mean[p]).square().sum());
    const double larger = std::max(formal, left_out);
    found[p] = std::isfinite(larger) ? larger : std::numeric_limits<double>::infinity();
  }
  return found;
}

/// In the unit of the key.
double value_at(const Place& place, std::size_t parameter) {
  return parameter == 0 ? std::exp(place[0]) : parameter == 1 ? std::clamp(place[1], 0.0, 1.0) : place[2];
}

double root_mean_square(const Eigen::VectorXd& values) {
  return values.size() > 0 ? std::sqrt(values.squaredNorm() / static_cast<double>(values.size())) : 0;
}

/// What the drive would be if the actual positions had been recorded later or earlier than the set ones.
struct Delayed {
  double delay = 0;           ///< of the actual positions that explains the record best [s]
  bool is_certain = false;    ///< none explains the record clearly worse
  std::vector<Place> places;  ///< of all delays that explain it about as well, without one among them
};

Delayed with_delays(const DriveRecord& record, const Place& found, Progress* progress) {
  constexpr int most = 200;
  struct Fit {
    double samples = 0;  ///< delay
    Place place;
    double cost = 0;
  };
  std::vector<Fit> fits;
  const auto try_one = [&](double samples, const Place& start) {
    const double delay = samples * record.period();
    const Place place = refined(record, start, most, progress, delay);
    fits.push_back({samples, place, record.residuals(drive_at(place), delay).squaredNorm()});
    return place;
  };
  // By whole samples: between two of them the rounding of the set positions would be smoothed.
  Place at = try_one(0, found);
  for (const double samples : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    at = try_one(samples, at);
  }
  at = fits.front().place;
  for (const double samples : {-1.0, -2.0, -4.0}) {
    at = try_one(samples, at);
  }
  const Fit best = *std::ranges::min_element(fits, {}, &Fit::cost);
  const double noise = guessed + guessed_share * root_mean_square(record.following_errors());
  const double allowed =
      std::max(best.cost * (1 + lasting_delay / independent(record.residuals(
                                                    drive_at(best.place), best.samples * record.period()))),
               noise * noise * static_cast<double>(record.size()));
  Delayed delayed{best.samples * record.period(), fits.front().cost > allowed, {}};
  for (const Fit& fit : fits) {
    if (fit.cost <= allowed) {
      delayed.places.push_back(fit.place);
    }
  }
  return delayed;
}

/// What nothing is told of, and why.
void leave(DriveFit& fit, const char* reason) {
  for (IdentifiedParameter& one : fit.parameters) {
    one.value = one.start;
    one.reason = reason;
  }
}

/// Tells nothing of what was told.
void distrust(DriveFit& fit, const char* reason) {
  for (IdentifiedParameter& one : fit.parameters) {
    one.told = false;
    one.uncertainty = 0;
  }
  leave(fit, reason);
}

/// Of drives that explain the record as well as the one that was found the simplest: without lag and
/// feed-forward where nothing of it is told, without lag, or itself. A drive whose feed-forward makes up for
/// a part of its lag can move as one without either.
Place simplest(const DriveRecord& record, const Place& found, bool any_told) {
  const Eigen::VectorXd residuals = record.residuals(drive_at(found));
  const double allowed = residuals.squaredNorm() * (1 + lasting / independent(residuals));
  const double gain = std::exp(found[0]);
  const Place simple(std::log(gain / std::max(1 - found[1], gain / most_gain)), 0, 0);
  if (!any_told && cost_at(record, simple) <= allowed) {
    return simple;
  }
  const Place without_lag(found[0], found[1], 0);
  return cost_at(record, without_lag) <= allowed ? without_lag : found;
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
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
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
  constexpr int most = 200;
  const Place found = refined(record, guess, most, progress);
  fit.left = root_mean_square(record.residuals(drive_at(found)));
  fit.explains = fit.left <= most_left * fit.following_error;
  if (!fit.explains) {
    constexpr double noise = 2e-3;  // [mm]: steps of encoders
    leave(fit, fit.following_error <= noise ? reason_follows : reason_unexplained);
    return fit;
  }
  const Delayed delayed = with_delays(DriveRecord(traces, index, first_samples, progress), found, progress);
  if (delayed.is_certain) {
    fit.delay = delayed.delay;
    fit.explains = false;
    leave(fit, reason_delayed);
    return fit;
  }
  const Place deviation = deviations_at(record, found, fit.following_error);
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    const auto i = static_cast<Eigen::Index>(p);
    IdentifiedParameter& one = fit.parameters[p];
    const bool is_share = p == 1;
    one.value = value_at(found, p);
    const double of = p == 2 ? std::max(found[i], std::numeric_limits<double>::min()) : 1;
    double off = told_deviations * deviation[i];
    for (const Place& other : delayed.places) {
      off = std::max(off, std::abs(other[i] - found[i]));
    }
    const double share = std::hypot(off / of, least_error[p]);
    const bool is_possible = !is_share || std::abs(found[i] - one.value) <= share;
    one.told = is_possible && share <= (is_share ? coarsest_share : coarsest_value);
    if (one.told) {
      one.uncertainty = is_share ? share : share * one.value;
    } else {
      const bool can_be_none = p > 0 && found[i] <= off;
      one.reason = !is_possible ? reason_beyond : can_be_none ? reason_smaller : reason_not_apart;
    }
  }
  // Then gain and lag stand in for an effect that a linear drive does not have.
  if (fit.parameters[1].reason == reason_beyond) {
    fit.explains = false;
    distrust(fit, reason_beyond);
    return fit;
  }
  const Place in_use =
      simplest(record, found, std::ranges::any_of(fit.parameters, &IdentifiedParameter::told));
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    IdentifiedParameter& one = fit.parameters[p];
    one.value = one.told ? one.value : value_at(in_use, p);
  }
  return fit;
}

void distrust_delayed(std::vector<DriveFit>& fits) {
  const auto late = std::ranges::find_if(fits, [](const DriveFit& fit) { return fit.delay != 0; });
  if (late == fits.end()) {
    return;
  }
  for (DriveFit& fit : fits) {
    if (fit.explains) {
      fit.delay = late->delay;
      fit.explains = false;
      distrust(fit, reason_delayed);
    }
  }
}

AxisDrive found_drive(const DriveFit& fit, const AxisDrive& start) {
  AxisDrive drive = start;
  if (!fit.explains) {
    return drive;
  }
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    const double value = fit.parameters[p].value;
    set_drive_value(drive, p, value > 0 || p == 0 ? SettingValue(value) : SettingValue(std::string()));
  }
  return drive;
}

}  // namespace feedscope
