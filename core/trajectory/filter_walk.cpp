#include "core/trajectory/filter_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace feedscope {
namespace {

/// In delays after the anchor: position of the time that requires a new anchor, so that small steps back
/// require no other one; and largest distance at which the integrals, which grow with its power n + 1, are
/// precise enough.
constexpr double first_instant = 1.5;
constexpr double farthest = 4;

/// (-1)^i C(n, i).
template <int filters>
constexpr std::array<double, filters + 1> binomials() {
  if constexpr (filters == 2) {
    return {1, -2, 1};
  } else {
    return {1, -3, 3, -1};
  }
}

/// 1/(2k + 5)! and 1/(2k + 4)!
constexpr std::array<std::array<double, 2>, 9> turn_series() {
  std::array<std::array<double, 2>, 9> all{};
  double inverse_factorial = 1.0 / 6;
  for (std::size_t k = 0; k < all.size(); ++k) {
    inverse_factorial /= static_cast<double>(2 * k + 4);
    all[k][1] = inverse_factorial;
    inverse_factorial /= static_cast<double>(2 * k + 5);
    all[k][0] = inverse_factorial;
  }
  return all;
}

/// The m-fold integrals of exp(i w h) - 1 over h^m, with x = w h: E_m = (exp(ix) - sum_(k<=m)
/// (ix)^k/k!)/(ix)^m.
struct TurnIntegrals {
  std::array<double, 4> re;
  std::array<double, 4> im;

  explicit TurnIntegrals(double x) {
    constexpr std::array<double, 4> inverse_factorial{1, 1, 1.0 / 2, 1.0 / 6};
    constexpr double series_up_to = 1.5;
    if (x > series_up_to) {
      re[0] = std::cos(x) - 1;
      im[0] = std::sin(x);
      for (std::size_t m = 1; m < 4; ++m) {
        re[m] = im[m - 1] / x - inverse_factorial[m];
        im[m] = -re[m - 1] / x;
      }
      return;
    }
    sum_third(x);
    for (std::size_t m = 3; m > 0; --m) {
      re[m - 1] = -x * im[m];
      im[m - 1] = x * (re[m] + inverse_factorial[m]);
    }
  }

 private:
  /// E_3 = sum_(k>0) (ix)^k/(k+3)!
  void sum_third(double x) {
    static constexpr std::array<std::array<double, 2>, 9> coefficients = turn_series();
    constexpr double few_terms_up_to = 0.4;
    const double square = -x * x;
    double even = 0;
    double odd = 0;
    for (std::size_t k = x < few_terms_up_to ? 5 : coefficients.size(); k-- > 0;) {
      even = even * square + coefficients[k][0];
      odd = odd * square + coefficients[k][1];
    }
    re[3] = even * square;
    im[3] = odd * x;
  }
};

/// P_lowest ... P_highest of a part `h` after its start; P_(-1) is the velocity.
template <int highest, int lowest>
using Integrals = std::array<Vec3, highest - lowest + 1>;

template <int highest, int lowest>
void add_turn(const CommandPart& part, double h, Integrals<highest, lowest>& out) {
  const TurnIntegrals turn(part.rate * h);
  double power = 1;
  for (int m = 0; m <= highest; ++m, power *= h) {
    if (m >= lowest) {
      const auto i = static_cast<std::size_t>(m);
      out[static_cast<std::size_t>(m - lowest)] +=
          (power * turn.re[i]) * part.cosine + (power * turn.im[i]) * part.sine;
    }
  }
  if constexpr (lowest < 0) {
    out[0] += part.rate * ((1 + turn.re[0]) * part.sine - turn.im[0] * part.cosine);
  }
}

/// Integral of a part without its turn: sum over k of P_(m-k) h^k/k! and of the velocity, which is P_(-1).
/// `h_over[k]` is h/k. Written out because it takes most of the time.
template <int m, typename Knot>
Vec3 straight_integral(const Knot& knot, const std::array<double, 5>& h_over) {
  const Vec3& v = knot.part.velocity;
  const auto& p = knot.integrals;
  if constexpr (m < 0) {
    return v;
  } else if constexpr (m == 0) {
    return p[0] + h_over[1] * v;
  } else if constexpr (m == 1) {
    return p[1] + h_over[1] * (p[0] + h_over[2] * v);
  } else if constexpr (m == 2) {
    return p[2] + h_over[1] * (p[1] + h_over[2] * (p[0] + h_over[3] * v));
  } else {
    return p[3] + h_over[1] * (p[2] + h_over[2] * (p[1] + h_over[3] * (p[0] + h_over[4] * v)));
  }
}

template <int highest, int lowest, typename Knot>
Integrals<highest, lowest> integrals_at(const Knot& knot, double h) {
  const std::array<double, 5> h_over{0, h, h / 2, h * (1.0 / 3), h / 4};
  Integrals<highest, lowest> out;
  out[0] = straight_integral<lowest>(knot, h_over);
  out[1] = straight_integral<lowest + 1>(knot, h_over);
  if constexpr (highest - lowest >= 2) {
    out[2] = straight_integral<lowest + 2>(knot, h_over);
  }
  if constexpr (highest - lowest >= 3) {
    out[3] = straight_integral<lowest + 3>(knot, h_over);
  }
  if constexpr (highest - lowest >= 4) {
    out[4] = straight_integral<lowest + 4>(knot, h_over);
  }
  if (knot.part.rate > 0) {
    add_turn<highest, lowest>(knot.part, h, out);
  }
  return out;
}

Kinematics kinematics_of(const CommandPart& part, double t) {
  const double h = t - part.time;
  Kinematics at{part.position + h * part.velocity, part.velocity, Vec3::Zero(), Vec3::Zero()};
  if (part.rate > 0) {
    const double w = part.rate;
    const double c = std::cos(w * h);
    const double s = std::sin(w * h);
    const Vec3 out = c * part.cosine + s * part.sine;
    const Vec3 along = c * part.sine - s * part.cosine;
    at.position += out - part.cosine;
    at.velocity += w * along;
    at.acceleration = -w * w * out;
    at.jerk = -w * w * w * along;
  }
  return at;
}

}  // namespace

Kinematics FilterWalk::at(const PulseTrain& train, double t) {
  seek(train, t);
  return train.filters == 2 ? evaluate<2>(t, true) : evaluate<3>(t, true);
}

Kinematics FilterWalk::motion_at(const PulseTrain& train, double t) {
  seek(train, t);
  return train.filters == 2 ? evaluate<2>(t, false) : evaluate<3>(t, false);
}

VelocityPoint FilterWalk::velocity_at(const PulseTrain& train, double t) {
  seek(train, t);
  return train.filters == 2 ? evaluate_velocity<2>(t) : evaluate_velocity<3>(t);
}

double FilterWalk::next_knot(const PulseTrain& train, double t) {
  seek(train, t);
  constexpr double never = std::numeric_limits<double>::infinity();
  double next = never;
  for (int i = 0; i <= train.filters; ++i) {
    const std::size_t after = cursor_[static_cast<std::size_t>(i)] + 1;
    const double begins = after < knots_.size() ? knots_[after].part.time : known_until_;
    next = std::min(next, begins + i * train.filter_time);
  }
  return std::max(next, std::nextafter(t, never));
}

/// Filters pass a velocity unchanged and reduce a turn by (sin x/x)^n with x = rate T1/2; both come out half
/// of the delay later.
CommandPart FilterWalk::settled_part() const {
  CommandPart part = knots_[cursor_[0]].part;
  part.time += train_->half_delay();
  if (part.rate > 0) {
    constexpr double small = 1e-4;
    const double x = part.rate * train_->filter_time / 2;
    const double one = x < small ? 1 - x * x / 6 : std::sin(x) / x;
    const double gain = train_->filters == 2 ? one * one : one * one * one;
    part.position -= (1 - gain) * part.cosine;
    part.cosine *= gain;
    part.sine *= gain;
  }
  return part;
}

bool FilterWalk::is_polynomial() const {
  return std::all_of(cursor_.begin(), cursor_.begin() + train_->filters + 1,
                     [this](std::size_t cursor) { return knots_[cursor].part.rate == 0; });
}

Kinematics FilterWalk::continued(double t) const {
  return train_->filters == 2 ? evaluate<2>(t, true) : evaluate<3>(t, true);
}

FilterWalk::Derivatives FilterWalk::continued_derivatives(double t) const {
  if (train_->filters == 3 && !is_settled()) {
    const auto d = differences<3, 3, -1>(t);
    return {anchor_ + d[4], d[3], d[2], d[1], d[0]};
  }
  const Kinematics at = continued(t);
  Vec3 fourth = Vec3::Zero();
  if (is_settled()) {
    const double rate = knots_[cursor_[0]].part.rate;
    fourth = -rate * rate * at.acceleration;
  } else if (!is_polynomial()) {  // commanded accelerations come from turns
    for (std::size_t i = 0; i <= 2; ++i) {
      const double commanded_at = t - static_cast<double>(i) * train_->filter_time;
      fourth += binomials<2>()[i] * kinematics_of(knots_[cursor_[i]].part, commanded_at).acceleration;
    }
    fourth /= train_->filter_time * train_->filter_time;
  }
  return {at.position, at.velocity, at.acceleration, at.jerk, fourth};
}

/// Averaging n times means differencing the n-fold integral: each average replaces one derivative by a factor
/// of up to 2/T1.
double FilterWalk::derivative_bound(int order) const {
  const auto count = static_cast<std::size_t>(train_->filters);
  const auto of_turn = [this](std::size_t cursor, int power) {
    const CommandPart& part = knots_[cursor].part;
    return part.rate > 0 ? part.cosine.norm() * std::pow(part.rate, power) : 0;
  };
  double sum = 0;
  for (std::size_t i = 0; i <= count; ++i) {
    const double weight = i == 0 || i == count ? 1 : static_cast<double>(count);
    sum += weight * of_turn(cursor_[i], order - train_->filters);
  }
  return sum / std::pow(train_->filter_time, train_->filters);
}

/// T1^-n sum_i (-1)^i C(n,i) P_m(t - i T1) for m from lowest to highest.
template <int filters, int highest, int lowest>
std::array<Vec3, highest - lowest + 1> FilterWalk::differences(double t) const {
  constexpr auto signs = binomials<filters>();
  Integrals<highest, lowest> sums;
  sums.fill(Vec3::Zero());
  const double since_anchor = t - anchor_time_;
  for (std::size_t i = 0; i <= filters; ++i) {
    const Knot& knot = knots_[cursor_[i]];
    const double age = since_anchor - static_cast<double>(i) * train_->filter_time;
    const auto terms = integrals_at<highest, lowest>(knot, age - knot.start);
    for (std::size_t m = 0; m < terms.size(); ++m) {
      sums[m] += signs[i] * terms[m];
    }
  }
  const double square = train_->filter_time * train_->filter_time;
  const double scale = 1 / (filters == 2 ? square : square * train_->filter_time);
  for (Vec3& sum : sums) {
    sum *= scale;
  }
  return sums;
}

template <int filters>
Kinematics FilterWalk::evaluate(double t, bool with_jerk) const {
  if (is_settled()) {
    return kinematics_of(settled_part(), t);
  }
  if (with_jerk) {
    const auto d = differences<filters, filters, filters - 3>(t);
    return {anchor_ + d[3], d[2], d[1], d[0]};
  }
  const auto d = differences<filters, filters, filters - 2>(t);
  return {anchor_ + d[2], d[1], d[0], Vec3::Zero()};
}

template <int filters>
VelocityPoint FilterWalk::evaluate_velocity(double t) const {
  if (is_settled()) {
    const Kinematics at = kinematics_of(settled_part(), t);
    return {at.velocity, at.acceleration};
  }
  const auto d = differences<filters, filters - 1, filters - 2>(t);
  return {d[1], d[0]};
}

void FilterWalk::seek(const PulseTrain& train, double t) {
  if (train_ != &train || t < anchor_time_ + train.delay() || t > anchor_time_ + farthest * train.delay()) {
    train_ = &train;
    restart(t - first_instant * train.delay());
  }
  while (known_until_ <= t) {
    append_block();
  }
  for (std::size_t i = 0; i <= static_cast<std::size_t>(train.filters); ++i) {
    const double age = t - anchor_time_ - static_cast<double>(i) * train.filter_time;
    std::size_t& cursor = cursor_[i];
    while (cursor + 1 < knots_.size() && knots_[cursor + 1].start <= age) {
      ++cursor;
    }
    while (cursor > 0 && knots_[cursor].start > age) {
      --cursor;
    }
  }
}

void FilterWalk::restart(double anchor_time) {
  knots_.clear();
  cursor_.fill(0);
  anchor_time_ = anchor_time;
  std::array<CommandPart, 3> parts{train_->rest_before(anchor_time)};
  std::size_t count = 1;
  next_block_ = 0;
  if (anchor_time >= 0) {
    next_block_ = train_->block_at(anchor_time);
    count = train_->parts(next_block_++, parts);
  }
  std::size_t k = 0;
  while (k + 1 < count && parts[k + 1].time <= anchor_time) {
    ++k;
  }
  parts[k].begin_later(anchor_time - parts[k].time);
  anchor_ = parts[k].position;
  knots_.push_back({parts[k], 0, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}});
  while (++k < count) {
    append(parts[k]);
  }
  find_known();
}

void FilterWalk::append_block() {
  std::array<CommandPart, 3> parts;
  const std::size_t count = train_->parts(next_block_, parts);
  for (std::size_t k = 0; k < count; ++k) {
    append(parts[k]);
  }
  ++next_block_;
  find_known();
}

void FilterWalk::find_known() {
  known_until_ = next_block_ <= train_->size() ? train_->blocks[next_block_].start
                                               : std::numeric_limits<double>::infinity();
}

void FilterWalk::append(const CommandPart& part) {
  const Knot& before = knots_.back();
  Knot knot;
  knot.part = part;
  knot.start = part.time - anchor_time_;
  knot.integrals = integrals_at<max_filters, 0>(before, knot.start - before.start);
  knot.integrals[0] = part.position - anchor_;
  knots_.push_back(knot);
}

}  // namespace feedscope
