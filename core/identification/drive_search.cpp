#include "core/identification/drive_search.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double least_gain = 1;    // [1/s]
constexpr double most_gain = 3000;  // [1/s]
constexpr double least_lag = 5e-4;  // [ms]: less has no effect, and counts as none
constexpr double most_lag = 100;    // [ms]
constexpr double place_step = 1e-3;

/// The task in the interface of Eigen's Levenberg-Marquardt, with only the free numbers. The lag may be
/// searched below 0; its sign does not matter.
class DriveTask {
 public:
  DriveTask(const FreeDriveNumbers& free, const DrivePlace& held, const DriveRecord& record, double delay,
            Progress* progress)
      : held_(held), record_(record), delay_(delay), progress_(progress) {
    for (Eigen::Index p = 0; p < held.size(); ++p) {
      if (free[static_cast<std::size_t>(p)]) {
        which_.push_back(p);
      }
    }
  }

  Eigen::VectorXd free_from(const DrivePlace& place) const {
    Eigen::VectorXd at(static_cast<Eigen::Index>(which_.size()));
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const Eigen::Index p = which_[static_cast<std::size_t>(i)];
      at[i] = place[p];
    }
    return at;
  }

  DrivePlace place_from(const Eigen::VectorXd& at) const {
    DrivePlace place = held_;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const Eigen::Index p = which_[static_cast<std::size_t>(i)];
      place[p] = p == 0   ? std::clamp(at[i], std::log(least_gain), std::log(most_gain))
                 : p == 2 ? std::min(std::abs(at[i]), most_lag)
                          : at[i];
    }
    return place;
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
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const bool is_lag = which_[static_cast<std::size_t>(i)] == 2;
      const double side = is_lag && at[i] < 0 ? -1 : 1;
      const double step = is_lag ? std::min(place_step, std::abs(at[i])) : place_step;  // towards 0
      Eigen::VectorXd moved = at;
      moved[i] = at[i] + side * place_step;
      (*this)(moved, above);
      moved[i] = at[i] - side * step;
      (*this)(moved, below);
      slopes.col(i) = side * (above - below) / (place_step + step);
    }
    return 0;
  }

 private:
  DrivePlace held_;
  const DriveRecord& record_;
  double delay_;
  Progress* progress_;
  std::vector<Eigen::Index> which_;
};

}  // namespace

AxisDrive drive_at(const DrivePlace& place) {
  AxisDrive drive;
  drive.gain = std::exp(place[0]);
  drive.feedforward = place[1];
  drive.lag = place[2] > least_lag ? units::from_ms(place[2]) : 0;
  return drive;
}

DrivePlace place_of(const AxisDrive& drive) {
  return {std::log(drive.gain.value_or(1)), drive.feedforward.value_or(0),
          units::to_ms(drive.lag.value_or(0))};
}

double drive_cost(const DriveRecord& record, const DrivePlace& place, double delay) {
  return record.residuals(drive_at(place), delay).squaredNorm();
}

DriveSearch DriveSearch::holding(std::size_t which, const DrivePlace& place) const {
  DriveSearch search = *this;
  search.free_[which] = false;
  search.held_[static_cast<Eigen::Index>(which)] = place[static_cast<Eigen::Index>(which)];
  return search;
}

DrivePlace DriveSearch::refined(const DriveRecord& record, const DrivePlace& start, int most,
                                double delay) const {
  constexpr double small = 0.5;  // [ms]
  if (!free_[2]) {
    return minimised(record, start, most, delay);
  }
  const DrivePlace found = minimised(record, {start[0], start[1], std::max(start[2], small)}, most, delay);
  if (found[2] > small) {
    return found;
  }
  // Steps beyond zero lag are mirrored, which may end the search next to it.
  const DrivePlace none(found[0], found[1], 0);
  const DrivePlace without = holding(2, none).minimised(record, none, most, delay);
  return drive_cost(record, without, delay) <= drive_cost(record, found, delay) ? without : found;
}

DrivePlace DriveSearch::minimised(const DriveRecord& record, const DrivePlace& start, int most,
                                  double delay) const {
  DriveTask task(free_, held_, record, delay, progress_);
  Eigen::LevenbergMarquardt<DriveTask> search(task);
  search.parameters.maxfev = most;
  search.parameters.xtol = 1e-9;
  search.parameters.ftol = 1e-12;
  Eigen::VectorXd at = task.free_from(start);
  if (at.size() > 0) {
    search.minimize(at);
  }
  return task.place_from(at);
}

/// Drives of all kinds with the lag `lag_time` at constant velocity [s], which follows directly from the
/// record; fixed numbers keep their values.
std::vector<DrivePlace> DriveSearch::drives_that_lag(double lag_time) const {
  std::vector<double> lags{0.1, 0.7, 2.0, 4.0, 8.0, 20.0};  // [ms]
  std::vector<double> feedforwards{0.0, 0.15, 0.3, 0.45, 0.6, 0.7, 0.8, 0.87, 0.93, 0.97, 0.99, 1.0};
  constexpr std::array full_gains{5.0, 10.0, 20.0, 35.0, 60.0, 100.0, 170.0, 300.0};  // [1/s]
  if (!free_[1]) {
    feedforwards = {held_[1]};
  }
  if (!free_[2]) {
    lags = {held_[2]};
  }
  std::vector<DrivePlace> places;
  for (const double lag : lags) {
    for (const double feedforward : feedforwards) {
      if (!free_[0]) {
        places.emplace_back(held_[0], feedforward, lag);
      } else if (feedforward < 1) {
        const double gain = (1 - feedforward) / std::max(lag_time, 1 / most_gain);
        places.emplace_back(std::log(std::clamp(gain, least_gain, most_gain)), feedforward, lag);
      } else {
        for (const double gain : full_gains) {
          places.emplace_back(std::log(gain), feedforward, lag);
        }
      }
    }
  }
  return places;
}

DrivePlace DriveSearch::first_guess(const DriveRecord& record) const {
  constexpr std::size_t refined_ones = 7;
  const std::size_t most_of_a_share = free_[1] ? 2 : refined_ones;  // start values with one feed-forward
  constexpr int most = 60;
  const std::vector<DrivePlace> places = drives_that_lag(record.lag_time());
  std::vector<std::pair<double, std::size_t>> costs(places.size());
  in_parallel(places.size(), [&](std::size_t i) {
    if (progress_ != nullptr && progress_->cancelled()) {
      throw Cancelled();
    }
    costs[i] = {drive_cost(record, places[i]), i};
  });
  std::ranges::sort(costs);
  std::vector<DrivePlace> starts;
  for (const auto& [cost, i] : costs) {
    const auto same =
        std::ranges::count(starts, places[i][1], [](const DrivePlace& start) { return start[1]; });
    if (starts.size() < refined_ones && static_cast<std::size_t>(same) < most_of_a_share) {
      starts.push_back(places[i]);
    }
  }
  std::vector<DrivePlace> best(starts.size());
  in_parallel(starts.size(), [&](std::size_t i) { best[i] = refined(record, starts[i], most); });
  return *std::ranges::min_element(best, {},
                                   [&](const DrivePlace& place) { return drive_cost(record, place); });
}

}  // namespace feedscope
