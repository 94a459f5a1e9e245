#include "core/identification/drive_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/translatable.h"
#include "core/identification/drive_record.h"
#include "core/identification/drive_search.h"
#include "core/identification/fit_parameter.h"

namespace feedscope {
namespace {

constexpr std::size_t most_samples = 400'000;
constexpr std::size_t first_samples = 30'000;  // for the first search
constexpr double least_reach = 0.5;            // [mm] that the axis must move
constexpr double most_left = 1.0 / 3;          // of the following error
constexpr double lasting = 12;                 // significant change of the sum of squares
constexpr double clearly_better = 100;         // likewise, if several alternatives are tried
constexpr int most_evaluations = 200;          // per search
constexpr double told_deviations = 2;          // standard deviations
constexpr double coarsest_value = 0.2;   // share of the value: with a larger uncertainty it is not determined
constexpr double coarsest_share = 0.05;  // with a larger uncertainty the feed-forward is not determined
/// Smallest uncertainty claimed: shares of gain and lag, absolute for the feed-forward.
constexpr std::array least_error{2e-3, 2e-3, 1e-2};
constexpr std::size_t left_out_parts = 12;  // of the record; each is omitted once
/// Residual of the guessed set position between samples, of one sign over long times [mm], and as a share of
/// the following error.
constexpr double guessed = 2e-6;
constexpr double guessed_share = 1e-5;

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
constexpr const char* reason_gain_alone =
    QT_TRANSLATE_NOOP("core",
                      "A smaller gain with feed-forward and lag explains the traces as well as the gain "
                      "alone, which is used. If "
                      "the control has no velocity feed-forward, look for the gain alone.");

double root_mean_square(const Eigen::VectorXd& values) {
  return values.size() > 0 ? std::sqrt(values.squaredNorm() / static_cast<double>(values.size())) : 0;
}

/// Number of independent residuals; consecutive ones are correlated.
double independent(const Eigen::VectorXd& residuals) {
  constexpr double most_correlated = 0.9999;
  const Eigen::Index n = residuals.size();
  const double square = residuals.squaredNorm();
  const double next = residuals.head(n - 1).dot(residuals.tail(n - 1));
  const double correlation = square > 0 ? std::clamp(next / square, 0.0, most_correlated) : 0;
  return std::max(1.0, static_cast<double>(n) * (1 - correlation) / (1 + correlation));
}

/// Derivatives of the residuals by the free numbers of a drive.
Eigen::MatrixXd slopes_at(const DriveRecord& record, const DrivePlace& place,
                          const std::vector<Eigen::Index>& free) {
  constexpr double place_step = 1e-3;
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(record.size()), static_cast<Eigen::Index>(free.size()));
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Eigen::Index p = free[i];
    DrivePlace above = place;
    DrivePlace below = place;
    above[p] += place_step;
    below[p] = p == 2 ? std::max(0.0, place[p] - place_step) : place[p] - place_step;
    slopes.col(static_cast<Eigen::Index>(i)) =
        (record.residuals(drive_at(above)) - record.residuals(drive_at(below))) / (above[p] - below[p]);
  }
  return slopes;
}

/// Possible residual of the guessed set position between samples [mm].
double guess_error(const DriveRecord& record) {
  return guessed + guessed_share * root_mean_square(record.following_errors());
}

/// Sum of squares up to which a record is explained as well as by the drive at `place`. `more`: significant
/// change of the sum, in units of noise.
double as_well(const DriveRecord& record, const DrivePlace& place, double more, double delay = 0) {
  const Eigen::VectorXd residuals = record.residuals(drive_at(place), delay);
  const double guess = guess_error(record);
  return std::max(residuals.squaredNorm() * (1 + more / independent(residuals)),
                  guess * guess * static_cast<double>(record.size()));
}

/// Standard deviations of the numbers of a drive, 0 for fixed ones.
DrivePlace deviations_at(const DriveRecord& record, const DrivePlace& place,
                         const FreeDriveNumbers& is_free) {
  std::vector<Eigen::Index> free;
  for (std::size_t p = 0; p < is_free.size(); ++p) {
    if (is_free[p]) {
      free.push_back(static_cast<Eigen::Index>(p));
    }
  }
  const Eigen::VectorXd residuals = record.residuals(drive_at(place));
  const Eigen::MatrixXd slopes = slopes_at(record, place, free);
  const Eigen::MatrixXd square = slopes.transpose() * slopes;
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(square.rows(), square.cols());
  const Eigen::MatrixXd inverse = square.ldlt().solve(unit);
  const double guess = guess_error(record);
  const double noise =
      std::max(residuals.squaredNorm() / independent(residuals),
               guess * guess * static_cast<double>(residuals.size()) / static_cast<double>(left_out_parts));
  Eigen::MatrixXd shifts(square.rows(), static_cast<Eigen::Index>(left_out_parts));
  for (std::size_t part = 0; part < left_out_parts; ++part) {
    const std::size_t size = record.size();
    const auto first = static_cast<Eigen::Index>(part * size / left_out_parts);
    const auto count = static_cast<Eigen::Index>((part + 1) * size / left_out_parts) - first;
    const auto rows = slopes.middleRows(first, count);
    const Eigen::VectorXd pull = rows.transpose() * residuals.segment(first, count);
    const Eigen::MatrixXd rest = square - rows.transpose() * rows;
    shifts.col(static_cast<Eigen::Index>(part)) = (rest + 1e-12 * square.trace() * unit).ldlt().solve(pull);
  }
  const Eigen::VectorXd mean = shifts.rowwise().mean();
  DrivePlace found = DrivePlace::Zero();
  for (Eigen::Index i = 0; i < square.rows(); ++i) {
    const double formal = std::sqrt(std::max(0.0, noise * inverse(i, i)));
    const double left_out =
        std::sqrt((left_out_parts - 1.0) / left_out_parts * (shifts.row(i).array() - mean[i]).square().sum());
    const double larger = std::max(formal, left_out);
    found[free[static_cast<std::size_t>(i)]] =
        std::isfinite(larger) ? larger : std::numeric_limits<double>::infinity();
  }
  return found;
}

/// Value in the unit of the key.
double value_at(const DrivePlace& place, std::size_t parameter) {
  return parameter == 0 ? std::exp(place[0]) : parameter == 1 ? std::clamp(place[1], 0.0, 1.0) : place[2];
}

/// Drives if the actual positions had been recorded later or earlier than the set ones.
struct Delayed {
  double delay = 0;                ///< delay of the actual positions that explains the record best [s]
  bool is_certain = false;         ///< without a delay the record is explained clearly worse
  std::vector<DrivePlace> places;  ///< for all delays that explain it about as well, including none
};

Delayed with_delays(const DriveRecord& record, const DriveSearch& search, const DrivePlace& found) {
  struct Fit {
    double delay = 0;  ///< [s]
    DrivePlace place;
    double cost = 0;
  };
  std::vector<Fit> fits;
  const auto try_one = [&](double samples, const DrivePlace& start) {
    const double delay = samples * record.period();
    const DrivePlace place = search.refined(record, start, most_evaluations, delay);
    fits.push_back({delay, place, drive_cost(record, place, delay)});
    return place;
  };
  // By whole samples: in between, rounding of the set positions would be smoothed.
  DrivePlace at = try_one(0, found);
  for (const double samples : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0}) {
    at = try_one(samples, at);
  }
  at = fits.front().place;
  for (const double samples : {-1.0, -2.0, -4.0}) {
    at = try_one(samples, at);
  }
  const Fit best = *std::ranges::min_element(fits, {}, &Fit::cost);
  const double allowed = as_well(record, best.place, clearly_better, best.delay);
  Delayed delayed{best.delay, fits.front().cost > allowed, {}};
  for (const Fit& fit : fits) {
    if (fit.cost <= allowed) {
      delayed.places.push_back(fit.place);
    }
  }
  return delayed;
}

/// Marks all parameters as not determined, with the reason.
void leave(DriveFit& fit, const char* reason) {
  for (IdentifiedParameter& one : fit.parameters) {
    one.value = one.start;
    one.reason = reason;
  }
}

/// Withdraws all determined values.
void distrust(DriveFit& fit, const char* reason) {
  fit.of_first_order = false;
  for (IdentifiedParameter& one : fit.parameters) {
    one.told = false;
    one.uncertainty = 0;
  }
  leave(fit, reason);
}

/// Guess of the set position between samples that explains a record best, with its drive; also the drive of
/// the other guess if that explains it as well. The curve if neither is better.
struct OnRecord {
  DriveRecord record;
  DrivePlace place;
  std::vector<DrivePlace> others;
};

OnRecord on_the_better_record(DriveRecord curve, DriveRecord line, const DriveSearch& search,
                              const DrivePlace& guess) {
  OnRecord curved{std::move(curve), guess, {}};
  OnRecord lined{std::move(line), guess, {}};
  curved.place = search.refined(curved.record, guess, most_evaluations);
  lined.place = search.refined(lined.record, curved.place, most_evaluations);
  // Rounding of the set positions favours one of the guesses by up to some percent: smaller differences are
  // not significant.
  constexpr double by_rounding = 1.05;
  const double on_curve = drive_cost(curved.record, curved.place);
  const double on_line = drive_cost(lined.record, lined.place);
  if (on_curve > std::max(by_rounding * on_line, as_well(lined.record, lined.place, lasting))) {
    return lined;
  }
  if (on_line <= std::max(by_rounding * on_curve, as_well(curved.record, curved.place, lasting))) {
    curved.others.push_back(lined.place);
  }
  return curved;
}

/// Drive with a feed-forward within 0 to 1, if it explains the record as well as `found`.
DrivePlace within_bounds(const DriveRecord& record, const DriveSearch& search, const DrivePlace& found) {
  DrivePlace held = found;
  held[1] = std::clamp(found[1], 0.0, 1.0);
  if (held[1] == found[1]) {
    return found;
  }
  const DrivePlace bounded = search.holding(1, held).refined(record, held, most_evaluations);
  return drive_cost(record, bounded) <= as_well(record, found, lasting) ? bounded : found;
}

/// Accepts the free numbers that are certain in spite of noise and of `others`, drives that explain the
/// record as well.
void judge(DriveFit& fit, const DrivePlace& found, const DrivePlace& deviation,
           const std::vector<DrivePlace>& others) {
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    IdentifiedParameter& one = fit.parameters[p];
    one.value = fit.free[p] ? value_at(found, p) : one.start;
    if (!fit.free[p]) {
      continue;
    }
    const auto i = static_cast<Eigen::Index>(p);
    const bool is_share = p == 1;
    const double of = p == 2 ? std::max(found[i], std::numeric_limits<double>::min()) : 1;
    double off = told_deviations * deviation[i];
    for (const DrivePlace& other : others) {
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
}

/// Uses the simplest drive that explains the record as well for values that are not determined: without lag
/// and feed-forward if nothing is determined, without lag, or the drive itself. A drive whose feed-forward
/// compensates part of its lag may move like one without either.
void use_simplest(DriveFit& fit, const DriveRecord& record, const DriveSearch& search,
                  const DrivePlace& found) {
  const double allowed = as_well(record, found, lasting);
  const bool any_told = std::ranges::any_of(fit.parameters, &IdentifiedParameter::told);
  const bool all_free = std::ranges::find(fit.free, false) == fit.free.end();
  DrivePlace in_use = found;
  if (!any_told && all_free) {
    constexpr double least_time = 1e-4;  // [s], time constant of the highest gain tried
    const double gain = std::exp(found[0]);
    const DrivePlace start(-std::log(std::max((1 - found[1]) / gain, least_time)), 0, 0);
    const DrivePlace alone =
        search.holding(1, start).holding(2, start).refined(record, start, most_evaluations);
    fit.of_first_order = drive_cost(record, alone) <= allowed;
    in_use = fit.of_first_order ? alone : in_use;
  }
  if (fit.of_first_order) {
    fit.parameters[0].reason = reason_gain_alone;
  } else if (fit.free[2] && drive_cost(record, {found[0], found[1], 0}) <= allowed) {
    in_use[2] = 0;
  }
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    IdentifiedParameter& one = fit.parameters[p];
    if (fit.free[p] && !one.told) {
      one.value = value_at(in_use, p);
    }
  }
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
                   FreeDriveNumbers free, Progress* progress) {
  DriveFit fit;
  fit.axis = axis;
  free[0] = free[0] || !start.gain;
  fit.free = free;
  for (std::size_t p = 0; p < drive_parameter_count; ++p) {
    fit.parameters[p].parameter = drive_parameter(axis, p);
    const SettingValue value = drive_value(start, p);
    const double* number = std::get_if<double>(&value);
    fit.parameters[p].start = number != nullptr ? *number : 0;
  }
  const auto index = static_cast<std::size_t>(axis - 'X');
  const auto record_of = [&](std::size_t most, BetweenSamples between) {
    return DriveRecord(traces, index, most, between, progress);
  };
  DriveRecord curve = record_of(most_samples, BetweenSamples::curve);
  fit.samples = curve.size();
  constexpr std::size_t least_samples = 200;
  if (curve.size() < least_samples || curve.reach() < least_reach) {
    leave(fit, axes_with_drives(traces).find(axis) == std::string::npos ? reason_unrecorded : reason_stands);
    return fit;
  }
  fit.following_error = root_mean_square(curve.following_errors());
  if (fit.following_error == 0) {
    leave(fit, reason_follows);
    return fit;
  }
  const DriveSearch search(free, place_of(start), progress);
  const DrivePlace guess = search.first_guess(record_of(first_samples, BetweenSamples::curve));
  const OnRecord best =
      on_the_better_record(std::move(curve), record_of(most_samples, BetweenSamples::line), search, guess);
  const DriveRecord& record = best.record;
  const DrivePlace found = within_bounds(record, search, best.place);
  const DriveRecord first = record_of(first_samples, record.between());
  if (!free[0] || !free[1] || !free[2]) {
    const DriveSearch any({true, true, true}, found, progress);
    const DrivePlace other = any.refined(record, any.first_guess(first), most_evaluations);
    if (drive_cost(record, found) > as_well(record, other, clearly_better)) {
      return fit_drive(traces, axis, start, {true, true, true}, progress);
    }
  }
  fit.left = root_mean_square(record.residuals(drive_at(found)));
  fit.explains = fit.left <= most_left * fit.following_error;
  if (!fit.explains) {
    constexpr double noise = 2e-3;  // [mm]: encoder steps
    leave(fit, fit.following_error <= noise ? reason_follows : reason_unexplained);
    return fit;
  }
  const Delayed delayed = with_delays(first, search, found);
  if (delayed.is_certain) {
    fit.delay = delayed.delay;
    fit.explains = false;
    leave(fit, reason_delayed);
    return fit;
  }
  std::vector<DrivePlace> others = best.others;
  others.insert(others.end(), delayed.places.begin(), delayed.places.end());
  judge(fit, found, deviations_at(record, found, free), others);
  // Gain and lag then account for an effect that a linear drive does not have.
  if (fit.parameters[1].reason == reason_beyond) {
    fit.explains = false;
    distrust(fit, reason_beyond);
    return fit;
  }
  use_simplest(fit, record, search, found);
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
    if (!fit.free[p]) {
      continue;
    }
    const double value = fit.parameters[p].value;
    set_drive_value(drive, p, value > 0 || p == 0 ? SettingValue(value) : SettingValue(std::string()));
  }
  return drive;
}

}  // namespace feedscope
