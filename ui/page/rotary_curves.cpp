#include "ui/page/rotary_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/analysis/envelope/rotary_walk.h"

namespace feedscope::ui {
namespace {

constexpr double deciding_share = 0.01;   // of the cycle time
constexpr double sampled_share = 0.0025;  // of a limit: how far the middle between two instants may be off
constexpr double first_thinned_share = 0.005;
constexpr double first_precision = 2 * sampled_share + first_thinned_share;  // more than the middle elsewhere
constexpr int least_curve_halvings = 1;
constexpr int most_curve_halvings = 10;

struct RotaryQuantity {
  CauseKind kind;
  double AxisState::*value;
  double RotaryAxis::*limit;
};
constexpr std::array quantities{
    RotaryQuantity{CauseKind::axis_velocity, &AxisState::velocity, &RotaryAxis::velocity},
    RotaryQuantity{CauseKind::axis_acceleration, &AxisState::acceleration, &RotaryAxis::acceleration},
    RotaryQuantity{CauseKind::axis_jerk, &AxisState::jerk, &RotaryAxis::jerk}};

/// Leaves out points between which the curve is straight within a tolerance: from the last point that is kept
/// a bundle of lines passes all since then.
class Thinning {
 public:
  explicit Thinning(double tolerance) : tolerance_(tolerance) {}

  void add(const CurvePoint& point) {
    if (kept_.empty()) {
      begin_at(point);
    } else if (!reaches(point)) {
      if (last_.time > kept_.back().time) {
        begin_at(last_);
      }
      if (!reaches(point)) {
        begin_at(point);  // it jumps
      }
    }
    narrow(point);
    last_ = point;
  }

  std::vector<CurvePoint> take() {
    if (!kept_.empty() && last_.time > kept_.back().time) {
      kept_.push_back(last_);
    }
    return std::move(kept_);
  }

 private:
  void begin_at(const CurvePoint& point) {
    kept_.push_back(point);
    low_ = -std::numeric_limits<double>::infinity();
    high_ = -low_;
  }

  bool reaches(const CurvePoint& point) const {
    const double time = point.time - kept_.back().time;
    const double rise = point.value - kept_.back().value;
    return time > 0 ? rise >= low_ * time && rise <= high_ * time : std::abs(rise) <= tolerance_;
  }

  void narrow(const CurvePoint& point) {
    const double time = point.time - kept_.back().time;
    if (time > 0) {
      const double rise = point.value - kept_.back().value;
      low_ = std::max(low_, (rise - tolerance_) / time);
      high_ = std::min(high_, (rise + tolerance_) / time);
    }
  }

  double tolerance_;
  std::vector<CurvePoint> kept_;
  CurvePoint last_;
  double low_ = 0;
  double high_ = 0;
};

/// The curve with at most `most` points.
void thin(RotaryCurve& curve, std::size_t most) {
  for (double share = 2 * first_thinned_share; curve.points.size() > most; share *= 2) {
    Thinning thinning(share * curve.limit);
    for (const CurvePoint& point : curve.points) {
      thinning.add(point);
    }
    curve.points = thinning.take();
    curve.precision += share;
  }
}

/// Looks at the axes so often that they run straight in between.
class CurveWalk {
 public:
  CurveWalk(std::vector<RotaryCurve>& curves, const std::vector<RotaryQuantity>& of)
      : curves_(curves), of_(of) {
    for (const RotaryCurve& curve : curves) {
      thinned_.emplace_back(first_thinned_share * curve.limit);
    }
  }

  void take(const std::shared_ptr<const RotaryCourse>& course, const Progress* progress) {
    const RotaryWalk::Source source(course);
    for (RotaryWalk walk(source, 0); !walk.done(); walk.next()) {
      stop_if_cancelled(progress);
      if (walk.end() > walk.begin()) {
        take_part(walk);
      }
    }
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      curves_[i].points = thinned_[i].take();
    }
  }

 private:
  struct Look {
    double time = 0;
    std::vector<double> values;
  };

  void take_part(RotaryWalk& walk) {
    std::vector<double> times = walk.turning_places();
    const RotaryLooks looks = walk.looks();
    for (int i = 0; i < looks.count(); ++i) {
      times.push_back(looks.at(i));
    }
    std::ranges::sort(times);
    Look before = look(walk, times.front());
    add(before);
    for (const double time : times) {
      if (time > before.time) {
        Look at = look(walk, time);
        divide(walk, before, at, 0);
        before = std::move(at);
      }
    }
  }

  /// `from` is there already.
  void divide(RotaryWalk& walk, const Look& from, const Look& to, int halvings) {
    const Look middle = look(walk, (from.time + to.time) / 2);
    if (halvings < most_curve_halvings &&
        (halvings < least_curve_halvings || !is_straight(from, middle, to))) {
      divide(walk, from, middle, halvings + 1);
      divide(walk, middle, to, halvings + 1);
    } else {
      add(middle);
      add(to);
    }
  }

  Look look(RotaryWalk& walk, double time) const {
    const RotarySample sample = walk.sample(time);
    Look look{time, {}};
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      look.values.push_back(sample.rotary[rotary_names.find(curves_[i].axis)].*of_[i].value);
    }
    return look;
  }

  bool is_straight(const Look& from, const Look& middle, const Look& to) const {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const double bend = middle.values[i] - (from.values[i] + to.values[i]) / 2;
      if (std::abs(bend) > sampled_share * curves_[i].limit) {
        return false;
      }
    }
    return true;
  }

  void add(const Look& at) {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      thinned_[i].add({at.time, at.values[i]});
    }
  }

  std::vector<RotaryCurve>& curves_;
  const std::vector<RotaryQuantity>& of_;
  std::vector<Thinning> thinned_;
};

}  // namespace

std::vector<CauseKind> deciding_rotary_limits(const Run& run) {
  std::vector<CauseKind> kinds;
  for (const RotaryQuantity& quantity : quantities) {
    double time = 0;
    for (std::size_t i = 0; i < run.summary.time_by_cause.size(); ++i) {
      const Cause& cause = all_causes()[i];
      const bool rotary = rotary_names.find(axis_name(cause)) != std::string_view::npos;
      time += cause.kind == quantity.kind && rotary ? run.summary.time_by_cause[i] : 0;
    }
    if (time > deciding_share * run.trajectory->duration()) {
      kinds.push_back(quantity.kind);
    }
  }
  return kinds;
}

std::vector<RotaryCurve> rotary_curves(const Run& run, const std::vector<CauseKind>& kinds, std::size_t most,
                                       const Progress* progress) {
  std::vector<RotaryCurve> curves;
  std::vector<RotaryQuantity> of;
  if (run.sources.rotary == nullptr) {
    return curves;
  }
  for (const RotaryQuantity& quantity : quantities) {
    for (const RotaryAxis& axis : run.setup.machine.kinematics.rotary) {
      if (std::ranges::find(kinds, quantity.kind) != kinds.end()) {
        curves.push_back({quantity.kind, axis.name, axis.*quantity.limit, first_precision, {}});
        of.push_back(quantity);
      }
    }
  }
  if (!curves.empty()) {
    CurveWalk(curves, of).take(run.sources.rotary, progress);
  }
  for (RotaryCurve& curve : curves) {
    thin(curve, most);
  }
  return curves;
}

}  // namespace feedscope::ui
