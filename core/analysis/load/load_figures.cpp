#include "core/analysis/load/load_figures.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/load/limit_tracker.h"
#include "core/analysis/load/load_sampler.h"
#include "core/base/translatable.h"
#include "core/trajectory/part_walk.h"

namespace feedscope {
namespace {

constexpr double longest_step = 0.002;  // [s]
constexpr double most_steps = 1e6;      // per part
constexpr double feed_rounding = 1e-9;  // relative
constexpr double same_value = 1e-9;     // relative; of equal values the first one is reported
constexpr std::size_t parts_per_report = 4096;

constexpr std::array<std::string_view, load_limit_count> limit_keys{
    "min_chip_um", "max_chip_um", "max_force_n", "max_torque_nm", "max_power_kw"};
constexpr std::array<std::string_view, load_limit_count> limit_titles{
    QT_TRANSLATE_NOOP("core", "chip below its least thickness (rubbing)"),
    QT_TRANSLATE_NOOP("core", "chip above its largest thickness"),
    QT_TRANSLATE_NOOP("core", "peak force above its bound"),
    QT_TRANSLATE_NOOP("core", "torque above its bound"),
    QT_TRANSLATE_NOOP("core", "power above its bound"),
};
constexpr std::array<std::size_t, load_limit_count> limit_quantities{1, 1, 3, 4, 5};

constexpr std::array<LoadQuantity, load_quantity_count> quantities_of_load{{
    {&CuttingLoad::feed_per_tooth, QuantityId::feed_per_tooth},
    {&CuttingLoad::chip_thickness, QuantityId::chip_thickness},
    {&CuttingLoad::mean_force, QuantityId::mean_force},
    {&CuttingLoad::peak_force, QuantityId::peak_force},
    {&CuttingLoad::torque, QuantityId::torque},
    {&CuttingLoad::power, QuantityId::power},
}};

/// Sums from which LoadTotals is made.
struct Sums {
  LoadTotals totals;
  double programmed_time = 0;  ///< of the same cutting at the programmed feed [s]
};

/// A sample of the run.
struct LoadLook {
  double time = 0;
  double speed = 0;
  double programmed_feed = 0;
  std::uint32_t line = 0;
  LoadSample sample;
};

class LoadCount {
 public:
  explicit LoadCount(const RunLoad& load)
      : model_(load.model()), sampler_(load), operations_(load.model().operations().size()) {
    for (std::size_t i = 0; i < load_limit_count; ++i) {
      const auto limit = static_cast<LoadLimit>(i);
      const bool set = std::any_of(
          model_.operations().begin(), model_.operations().end(),
          [&](const LoadedOperation& operation) { return bound_of(limit, operation.operation).has_value(); });
      if (set) {
        limits_.push_back(limit);
        trackers_.emplace_back(limit);
      }
    }
  }

  void add(const Part& part, const PartMotion& motion) {
    LoadLook from = look(motion, part, 0);
    if (from.sample.state != LoadState::cutting && from.sample.state != LoadState::plunge) {
      time_[static_cast<std::size_t>(from.sample.state)] += part.duration;
      return;
    }
    const LoadLook middle = look(motion, part, part.duration / 2);
    const LoadLook end = look(motion, part, part.duration);
    if (part.duration <= longest_step || is_steady(from, middle, end)) {
      add_step(from, middle, end, part.duration);
      return;
    }
    const double wanted = std::ceil(part.duration / longest_step);
    const int steps = static_cast<int>(std::min(wanted, most_steps));
    for (int i = 0; i < steps; ++i) {
      const LoadLook middle = look(motion, part, part.duration * (i + 0.5) / steps);
      const LoadLook to = look(motion, part, part.duration * (i + 1) / steps);
      add_step(from, middle, to, part.duration / steps);
      from = to;
    }
  }

  LoadFigures finish() {
    LoadFigures figures;
    figures.time = time_;
    figures.all = totals_of(all_);
    for (const Sums& sums : operations_) {
      figures.operations.push_back(totals_of(sums));
    }
    for (LimitTracker& tracker : trackers_) {
      figures.limits.push_back(tracker.finish());
    }
    return figures;
  }

 private:
  LoadLook look(const PartMotion& motion, const Part& part, double tau) {
    const State state = motion.state_without_length(tau);
    return {part.time + tau, state.speed, state.programmed_feed, state.line, sampler_.at(state)};
  }

  static bool is_steady(const LoadLook& a, const LoadLook& b, const LoadLook& c) {
    const auto same = [&](const LoadLook& other) {
      const CuttingLoad& one = a.sample.predicted;
      return other.sample.state == a.sample.state &&
             std::abs(other.sample.predicted.feed_per_tooth - one.feed_per_tooth) <=
                 feed_rounding * one.feed_per_tooth;
    };
    return same(b) && same(c);
  }

  void add_step(const LoadLook& from, const LoadLook& middle, const LoadLook& to, double duration) {
    const LoadState state = middle.sample.state;
    time_[static_cast<std::size_t>(state)] += duration;
    if (state != LoadState::cutting) {
      return;
    }
    for (Sums* sums : {&all_, &operations_[static_cast<std::size_t>(middle.sample.operation)]}) {
      sums->totals.cutting_time += duration;
      for (const auto& [look, weight] :
           {std::pair(&from, 1.0 / 6), std::pair(&middle, 4.0 / 6), std::pair(&to, 1.0 / 6)}) {
        if (look->sample.has_load()) {
          add_look(*sums, *look, weight * duration);
        }
      }
    }
    track(from, middle);
    track(middle, to);
  }

  static void add_look(Sums& sums, const LoadLook& look, double duration) {
    const double programmed = look.programmed_feed > 0 ? duration * look.speed / look.programmed_feed : 0;
    sums.programmed_time += programmed;
    for (std::size_t i = 0; i < load_quantity_count; ++i) {
      const auto add_to = [&](LoadFigure& figure, const CuttingLoad& load, double weight) {
        const double value = load.*load_quantities()[i].member;
        figure.mean += value * weight;
        if (figure.line == 0 || value > figure.largest * (1 + same_value)) {
          figure.largest = value;
          figure.time = look.time;
          figure.line = look.line;
        }
      };
      add_to(sums.totals.predicted[i], look.sample.predicted, duration);
      add_to(sums.totals.programmed[i], look.sample.programmed, programmed);
    }
  }

  void track(const LoadLook& from, const LoadLook& to) {
    if (!from.sample.has_load() || !to.sample.has_load()) {
      return;
    }
    const int operation = to.sample.operation;
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const auto bound =
          bound_of(limits_[i], model_.operations()[static_cast<std::size_t>(operation)].operation);
      if (!bound) {
        continue;
      }
      const auto member = load_quantities()[quantity_of(limits_[i])].member;
      const auto look = [&](const LoadLook& at) {
        return LimitTracker::Look{at.time, at.line, at.sample.predicted.*member,
                                  at.sample.programmed.*member};
      };
      trackers_[i].add(look(from), look(to), operation, *bound);
    }
  }

  static LoadTotals totals_of(const Sums& sums) {
    LoadTotals totals = sums.totals;
    for (std::size_t i = 0; i < load_quantity_count; ++i) {
      totals.predicted[i].mean /= totals.cutting_time > 0 ? totals.cutting_time : 1;
      totals.programmed[i].mean /= sums.programmed_time > 0 ? sums.programmed_time : 1;
    }
    return totals;
  }

  const LoadModel& model_;
  LoadSampler sampler_;
  Sums all_;
  std::vector<Sums> operations_;
  std::array<double, load_state_count> time_{};
  std::vector<LoadLimit> limits_;
  std::vector<LimitTracker> trackers_;  ///< in the order of limits_
};

}  // namespace

const std::array<LoadQuantity, load_quantity_count>& load_quantities() {
  return quantities_of_load;
}

const LoadFigure& figure_of(const LoadFigureList& figures, QuantityId id) {
  const auto found = std::ranges::find(quantities_of_load, id, &LoadQuantity::id);
  return figures[static_cast<std::size_t>(found - quantities_of_load.begin())];
}

double in_file_unit(const LoadQuantity& quantity, double value) {
  return value * shown_unit(info_of(quantity.id).dimension).factor;
}

std::string_view key_of(LoadLimit limit) {
  return limit_keys[static_cast<std::size_t>(limit)];
}

std::string_view title_of(LoadLimit limit) {
  return limit_titles[static_cast<std::size_t>(limit)];
}

std::size_t quantity_of(LoadLimit limit) {
  return limit_quantities[static_cast<std::size_t>(limit)];
}

std::string_view load_assumptions() {
  return QT_TRANSLATE_NOOP("core",
                           "engagement as given, not simulated along the path; circular "
                           "tooth path, no runout, no "
                           "deflection; coefficients of the material as given");
}

LoadFigures load_figures(const RunLoad& load, Progress* progress) {
  const Trajectory& trajectory = load.trajectory();
  LoadCount count(load);
  std::size_t parts = 0;
  for (PartWalk walk(trajectory); !walk.done(); walk.next()) {
    count.add(walk.part(), walk.motion());
    if (progress != nullptr && ++parts % parts_per_report == 0) {
      progress->report(walk.part().time / trajectory.duration());
    }
  }
  return count.finish();
}

}  // namespace feedscope
