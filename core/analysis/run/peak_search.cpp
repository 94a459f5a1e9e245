#include "core/analysis/run/peak_search.h"

#include <algorithm>
#include <cmath>

namespace feedscope {
namespace {

constexpr double turn_per_span = 0.25;        // rad of an arc
constexpr double parameter_per_span = 0.125;  // of a blend run by its parameter, or of a curve
constexpr double spread_per_span = 0.4;       // of a blend run by path length, as BlendSpread
constexpr double looks_per_filter_time = 16;  // where turning pulses change
constexpr double most_spans = 1e6;            // per part

/// Derivatives by time, first to fourth, by the chain rule. `d`: of a course by its parameter; `u`: of the
/// parameter by time.
std::array<Vec3, 4> rates_of(const std::array<Vec3, 4>& d, const std::array<double, 4>& u) {
  const double square = u[0] * u[0];
  return {d[0] * u[0], d[1] * square + d[0] * u[1],
          d[2] * (square * u[0]) + d[1] * (3 * u[0] * u[1]) + d[0] * u[2],
          d[3] * (square * square) + d[2] * (6 * square * u[1]) + d[1] * (3 * u[1] * u[1] + 4 * u[0] * u[2]) +
              d[0] * u[3]};
}

/// Derivatives by time if the path length follows `law`: from s' = g u', where g is the length of d[0].
std::array<Vec3, 4> rates_by_length(const std::array<Vec3, 4>& d, const LawPoint& law) {
  const double g = d[0].norm();
  const double g1 = d[0].dot(d[1]) / g;
  const double g2 = (d[1].squaredNorm() + d[0].dot(d[2]) - g1 * g1) / g;
  const double g3 = (3 * d[1].dot(d[2]) + d[0].dot(d[3]) - 3 * g1 * g2) / g;
  const double u1 = law.v / g;
  const double square = u1 * u1;
  const double u2 = (law.a - g1 * square) / g;
  const double u3 = (law.j - g2 * square * u1 - 3 * g1 * u1 * u2) / g;
  const double u4 = -(g3 * square * square + 6 * g2 * square * u2 + g1 * (3 * u2 * u2 + 4 * u1 * u3)) / g;
  return rates_of(d, {u1, u2, u3, u4});
}

std::array<Vec3, 4> blend_derivatives(const CubicBlend& blend, double u) {
  const CurvePoint at = blend.at(std::clamp(u, 0.0, 1.0));
  return {at.d1, at.d2, at.d3, Vec3::Zero()};
}

/// Places on a blend that are the denser the slower its parameter passes it: with u = 1/2 + w sinh(x) its
/// speed |S'| is about |S'(1/2)| cosh(x), and one step of x suits every turn.
class BlendSpread {
 public:
  explicit BlendSpread(const CubicBlend& blend) {
    constexpr double widest = 10;
    constexpr double narrowest = 1e-12;
    const CurvePoint middle = blend.at(0.5);
    const double bend = middle.d2.squaredNorm() + middle.d1.dot(middle.d3);
    width_ = bend > 0 ? std::clamp(middle.d1.norm() / std::sqrt(bend), narrowest, widest) : widest;
  }
  double x(double u) const { return std::asinh((u - 0.5) / width_); }
  double u(double x) const { return 0.5 + width_ * std::sinh(x); }

 private:
  double width_;
};

/// Roots of a + b t + c t^2 / 2, and the root of its derivative.
std::array<double, 3> roots_and_turn(double a, double b, double c) {
  const double root = std::sqrt(b * b - 2 * a * c);
  const double sum = -(b + std::copysign(root, b));
  return {sum / c, 2 * a / sum, -b / c};
}

}  // namespace

double PeakSearch::value(const Look& look, std::size_t quantity) {
  return quantity == speed_place
             ? look.rates[0].norm()
             : look.rates[quantity / axis_count][static_cast<Eigen::Index>(quantity % axis_count)];
}

double PeakSearch::slope(const Look& look, std::size_t quantity) {
  return quantity == speed_place
             ? look.rates[0].dot(look.rates[1]) / look.rates[0].norm()
             : look.rates[1 + quantity / axis_count][static_cast<Eigen::Index>(quantity % axis_count)];
}

template <typename RatesAt>
PeakSearch::Look PeakSearch::look(const RatesAt& rates_at, double time) {
  const Look look{time, rates_at(time)};
  for (std::size_t q = 0; q < largest_.size(); ++q) {
    largest_[q] = std::max(largest_[q], std::abs(value(look, q)));
  }
  return look;
}

template <typename RatesAt>
void PeakSearch::search(const RatesAt& rates_at, double from, double to, double spans, std::size_t first) {
  const int count = static_cast<int>(std::clamp(std::ceil(spans), 1.0, most_spans));
  Look before = look(rates_at, from);
  for (int i = 1; i <= count; ++i) {
    const Look at = look(rates_at, i < count ? from + (to - from) * i / count : to);
    search_span(rates_at, before, at, first);
    before = at;
  }
}

template <typename RatesAt>
void PeakSearch::look_at_turn(const RatesAt& rates_at, const Part& part, double from, double to) {
  const double turn = -part.a / part.j;
  if (turn > from && turn < to) {
    look(rates_at, turn);
  }
}

template <typename RatesAt>
void PeakSearch::search_span(const RatesAt& rates_at, const Look& from, const Look& to, std::size_t first) {
  constexpr double rounding = 1 + 1e-12;
  const double duration = to.time - from.time;
  for (std::size_t q = first; q < largest_.size(); ++q) {
    const double begins = slope(from, q);
    const double ends = slope(to, q);
    const double higher = std::max(std::abs(value(from, q)), std::abs(value(to, q)));
    if (begins * ends < 0 &&
        higher + duration * std::max(std::abs(begins), std::abs(ends)) > largest_[q] * rounding) {
      narrow(rates_at, from, to, q);
    }
  }
}

/// Narrows down a peak between two samples with slopes of opposite sign. Secants; an end that stays gets half
/// the weight.
template <typename RatesAt>
void PeakSearch::narrow(const RatesAt& rates_at, Look low, Look high, std::size_t quantity) {
  constexpr int most_steps = 60;
  constexpr double precision = 1e-11;
  double at_low = slope(low, quantity);
  double at_high = slope(high, quantity);
  int stays = 0;
  for (int i = 0; i < most_steps; ++i) {
    const double width = high.time - low.time;
    const Look middle = look(rates_at, low.time + width * at_low / (at_low - at_high));
    const double at = slope(middle, quantity);
    if (!(std::abs(at) * width > precision * largest_[quantity])) {
      return;
    }
    if (at * at_low > 0) {
      low = middle;
      at_low = at;
      at_high /= stays > 0 ? 2 : 1;
      stays = 1;
    } else {
      high = middle;
      at_high = at;
      at_low /= stays < 0 ? 2 : 1;
      stays = -1;
    }
  }
}

void PeakSearch::add(const Trajectory& trajectory, const Part& part) {
  const ElementKind kind = trajectory.path().kind(part.element);
  if (kind == ElementKind::dwell) {
    return;
  }
  if (part.law == Law::filtered) {
    add_filtered(part, trajectory.motion_of(part.element));
    return;
  }
  const ElementCurve curve = trajectory.path().curve(part.element);
  if (curve.is_arc()) {
    add_arc(part, curve.arc);
  } else if (part.law == Law::parameter) {
    add_blend(part, curve.blend);
  } else if (kind == ElementKind::blend) {
    add_blend_by_length(part, curve);
  } else if (curve.course.empty()) {
    add_line(part, curve.direction);
  } else {
    for (std::size_t i = 1; i < curve.course.size(); ++i) {
      add_course(part, curve.course[i - 1], curve.course[i]);
    }
  }
}

void PeakSearch::add(const PeakSearch& other) {
  for (std::size_t q = 0; q < largest_.size(); ++q) {
    largest_[q] = std::max(largest_[q], other.largest_[q]);
  }
}

AxisVector<AxisPeaks> PeakSearch::axes(bool with_jerk) const {
  AxisVector<AxisPeaks> axes;
  for (std::size_t i = 0; i < axis_count; ++i) {
    axes[i] = {largest_[i], largest_[axis_count + i],
               with_jerk ? largest_[2 * axis_count + i] : std::numeric_limits<double>::quiet_NaN()};
  }
  return axes;
}

/// Largest magnitudes of the law itself.
PeakSearch::LawPeaks PeakSearch::peaks_of(const Part& part) {
  const LawPoint end = law_at(part, part.duration);
  const double turn = -part.a / part.j;
  const double turns_at = turn > 0 && turn < part.duration ? law_at(part, turn).v : 0;
  return {std::max({std::abs(part.v), std::abs(end.v), std::abs(turns_at)}),
          std::max(std::abs(part.a), std::abs(end.a)), std::abs(part.j)};
}

void PeakSearch::add_line(const Part& part, const Vec3& direction) {
  const LawPeaks law = peaks_of(part);
  for (std::size_t i = 0; i < axis_count; ++i) {
    const double share = std::abs(direction[static_cast<Eigen::Index>(i)]);
    largest_[i] = std::max(largest_[i], law.v * share);
    largest_[axis_count + i] = std::max(largest_[axis_count + i], law.a * share);
    largest_[2 * axis_count + i] = std::max(largest_[2 * axis_count + i], law.j * share);
  }
  largest_[speed_place] = std::max(largest_[speed_place], law.v * direction.norm());
}

/// Whether the bounds of all terms of the chain rule on an arc add up to nothing above the values so far: the
/// case for consecutive arcs at constant speed.
bool PeakSearch::is_known(const LawPeaks& law, const Arc& arc) const {
  constexpr double rounding = 1 + 1e-12;
  const double rate = 1 / arc.length_per_radian();
  bool known = law.v <= largest_[speed_place] * rounding;
  for (std::size_t i = 0; known && i < axis_count; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double turning =
        rate * arc.radius * std::sqrt(arc.x[axis] * arc.x[axis] + arc.y[axis] * arc.y[axis]);
    const double d1 = turning + rate * std::abs(arc.rise[axis]);
    const double d2 = rate * turning;
    const double d3 = rate * d2;
    known = law.v * d1 <= largest_[i] * rounding &&
            law.v * law.v * d2 + law.a * d1 <= largest_[axis_count + i] * rounding &&
            law.v * law.v * law.v * d3 + 3 * law.v * law.a * d2 + law.j * d1 <=
                largest_[2 * axis_count + i] * rounding;
  }
  return known;
}

void PeakSearch::add_arc(const Part& part, const Arc& arc) {
  if (is_known(peaks_of(part), arc)) {
    return;
  }
  const double rate = 1 / arc.length_per_radian();
  const auto at = [&](double tau) {
    const LawPoint law = law_at(part, tau);
    const CurvePoint place = arc.at(law.q);
    return rates_of({place.d1, place.d2, place.d3, -rate * rate * place.d2}, {law.v, law.a, law.j, 0});
  };
  const double end_speed = law_at(part, part.duration).v;
  const double turn = std::max(std::abs(part.v), std::abs(end_speed)) * part.duration * rate;
  look_at_turn(at, part, 0, part.duration);
  search(at, 0, part.duration, 2 + turn / turn_per_span);
}

void PeakSearch::add_blend(const Part& part, const CubicBlend& blend) {
  const auto at = [&](double tau) {
    const LawPoint law = law_at(part, tau);
    return rates_of(blend_derivatives(blend, law.q), {law.v, law.a, law.j, 0});
  };
  const double share = law_at(part, part.duration).q - part.q;
  search(at, 0, part.duration, 2 + share / parameter_per_span);
}

void PeakSearch::add_blend_by_length(const Part& part, const ElementCurve& curve) {
  const CubicBlend& blend = curve.blend;
  const auto rates_at = [&](double tau, double u) {
    return rates_by_length(blend_derivatives(blend, u), law_at(part, tau));
  };
  const auto at = [&](double tau) { return rates_at(tau, blend.parameter_at(law_at(part, tau).q)); };
  look_at_turn(at, part, 0, part.duration);
  const LawPoint start = law_at(part, 0);
  const BlendSpread spread(blend);
  const double first = blend.parameter_at(part.q);
  const double last = blend.parameter_at(law_at(part, part.duration).q);
  const double x = spread.x(first);
  const double step = (spread.x(last) - x) / (2 + std::floor((spread.x(last) - x) / spread_per_span));
  const auto look_at = [&](double tau, double u) {
    return look([&](double) { return rates_at(tau, u); }, tau);
  };
  Look before = look_at(0, first);
  for (double i = 1; before.time < part.duration; ++i) {
    const double u = std::min(spread.u(x + i * step), last);
    const bool ends = !(u < last - 1e-9);
    const Look next = ends ? look_at(part.duration, last)
                           : look_at(time_to_reach(start, blend.length_to(u), part.duration), u);
    search_span(at, before, next);
    before = next;
  }
}

/// Searches the time of the part on the span between two knots of a course, if any.
void PeakSearch::add_course(const Part& part, const CourseKnot& from, const CourseKnot& to) {
  const LawPoint start = law_at(part, 0);
  const double begin = time_to_reach(start, from.s, part.duration);
  const double end = time_to_reach(start, to.s, part.duration);
  if (!(begin < end)) {
    return;
  }
  const CourseSpan span(from, to);
  const auto at = [&](double tau) {
    const LawPoint law = law_at(part, tau);
    return rates_by_length(span.derivatives(law.q - from.s), law);
  };
  look_at_turn(at, part, begin, end);
  const double share = (law_at(part, end).q - law_at(part, begin).q) / span.length();
  search(at, begin, end, 2 + share / parameter_per_span);
}

void PeakSearch::add_filtered(const Part& part, const FilteredMotion& motion) {
  const PulseTrain& train = motion.train();
  const double end = part.time - motion.start() + part.duration;
  const double rounding = 1e-9 * train.filter_time;  // knots closer than this are one
  double next = 0;
  for (double time = end - part.duration; time < end; time = next) {
    next = std::min(end, filters_.next_knot(train, time + rounding));
    const auto at = [&](double t) {
      const FilterWalk::Derivatives d = filters_.continued_derivatives(t);
      return Rates{d[1], d[2], d[3], d[4]};
    };
    if (filters_.is_polynomial()) {
      add_polynomial(at(time), next - time);
    } else if (filters_.is_settled()) {
      search(at, time, next, 2 + filters_.settled_part().rate * (next - time) / turn_per_span);
    } else {
      search(at, time, next, 2 + (next - time) / train.filter_time * looks_per_filter_time);
    }
  }
}

/// Motion with a constant derivative of the jerk. The acceleration of each axis has its extremes where the
/// jerk is 0, the velocity where the acceleration is 0.
void PeakSearch::add_polynomial(const Rates& start, double duration) {
  const auto at = [&](double t) {
    const auto& [v, a, j, s] = start;
    return Rates{v + t * (a + t * (j / 2 + t / 6 * s)), a + t * (j + t / 2 * s), j + t * s, s};
  };
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (const double root : roots_and_turn(start[1][i], start[2][i], start[3][i])) {
      if (root > 0 && root < duration) {
        look(at, root);
      }
    }
  }
  search(at, 0, duration, 2, speed_place);
}

}  // namespace feedscope
