#include "core/trajectory/trajectory.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace feedscope {
namespace {

struct LawPoint {
  double q, v, a, j;
};

LawPoint law_at(const Piece& p, double tau) {
  return {p.q + tau * (p.v + tau * (p.a / 2 + tau * p.j / 6)), p.v + tau * (p.a + tau * p.j / 2),
          p.a + tau * p.j, p.j};
}

Kinematics kinematics_of(const CurvePoint& at, const LawPoint& law) {
  return {at.position, at.d1 * law.v, at.d2 * (law.v * law.v) + at.d1 * law.a,
          at.d3 * (law.v * law.v * law.v) + at.d2 * (3 * law.v * law.a) + at.d1 * law.j};
}

/// First tau in [0, duration] at which a non-decreasing law reaches `target`.
double law_inverse(const Piece& p, double target, double duration) {
  if (p.q >= target) {
    return 0;
  }
  double low = 0;
  double high = duration;
  double tau = duration / 2;
  for (int i = 0; i < 100 && high - low > 1e-15 * (1 + duration); ++i) {
    const LawPoint at = law_at(p, tau);
    (at.q < target ? low : high) = tau;
    const double newton = tau - (at.q - target) / at.v;
    tau = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return high;
}

}  // namespace

Trajectory::Trajectory(BlendedPath path, std::vector<Piece> pieces, double duration,
                       std::vector<BlendRecord> blends, std::vector<std::uint32_t> lines,
                       std::vector<double> feeds, std::vector<bool> rapid, double compaction_error,
                       std::vector<FilteredMotion> motions)
    : path_(std::move(path)),
      pieces_(std::move(pieces)),
      duration_(duration),
      blends_(std::move(blends)),
      lines_(std::move(lines)),
      feeds_(std::move(feeds)),
      rapid_(std::move(rapid)),
      compaction_error_(compaction_error),
      motions_(std::move(motions)) {
  assert(lines_.size() == path_.elements.size() && feeds_.size() == lines_.size() &&
         rapid_.size() == lines_.size());
  fill_blend_speeds();
}

void Trajectory::fill_blend_speeds() {
  std::size_t piece = 0;
  for (BlendRecord& record : blends_) {
    while (piece < pieces_.size() && pieces_[piece].element < record.element) {
      ++piece;
    }
    if (piece == pieces_.size() || pieces_[piece].element != record.element ||
        pieces_[piece].law == Law::filtered) {
      continue;
    }
    record.entry_speed = kinematics_in_piece(piece, 0).velocity.norm();
    while (piece + 1 < pieces_.size() && pieces_[piece + 1].element == record.element) {
      ++piece;
    }
    record.exit_speed = kinematics_in_piece(piece, piece_end(piece) - pieces_[piece].time).velocity.norm();
  }
}

double Trajectory::piece_end(std::size_t piece) const {
  return piece + 1 < pieces_.size() ? pieces_[piece + 1].time : duration_;
}

std::size_t Trajectory::piece_at(double time) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](double t, const Piece& p) { return t < p.time; });
  return after == pieces_.begin() ? 0 : static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

State Trajectory::state(double time) const {
  if (pieces_.empty()) {
    State rest;
    rest.position = rest.velocity = rest.acceleration = rest.jerk = Vec3::Zero();
    return rest;
  }
  const double t = std::clamp(time, 0.0, duration_);
  const std::size_t piece = piece_at(t);
  return state_in_piece(piece, t - pieces_[piece].time);
}

CurvePoint Trajectory::curve_point(const Piece& piece, double q) const {
  const PathElement& element = path_.elements[piece.element];
  return piece.law == Law::parameter ? path_.blends[element.geometry].at(std::clamp(q, 0.0, 1.0))
                                     : path_.at(element, std::clamp(q, 0.0, element.length));
}

const FilteredMotion& Trajectory::motion_of(const Piece& piece) const {
  return motions_[path_.elements[piece.element].geometry];
}

int Trajectory::filtered_spans(std::size_t index, double a_filter_time) const {
  const Piece& piece = pieces_[index];
  const FilteredMotion& motion = motion_of(piece);
  const double start = piece.time - motion.start();
  const double end = piece_end(index) - motion.start();
  if (motion.is_settled(start, end)) {
    return 1;
  }
  constexpr double most = 1e6;
  return static_cast<int>(
      std::ceil(std::clamp((end - start) / motion.filter_time() * a_filter_time, 1.0, most)));
}

double Trajectory::piece_length(std::size_t index) const {
  const Piece& piece = pieces_[index];
  const bool last = index + 1 == pieces_.size() || pieces_[index + 1].element != piece.element;
  return (last ? path_.elements[piece.element].length : pieces_[index + 1].q) - piece.q;
}

Kinematics Trajectory::kinematics_in_piece(std::size_t index, double tau) const {
  const Piece& piece = pieces_[index];
  if (piece.law == Law::filtered) {
    const FilteredMotion& motion = motion_of(piece);
    return motion.at(piece.time - motion.start() + tau);
  }
  const LawPoint law = law_at(pieces_[index], tau);
  return kinematics_of(curve_point(pieces_[index], law.q), law);
}

State Trajectory::state_in_piece(std::size_t index, double tau) const {
  const Piece& piece = pieces_[index];
  const PathElement& element = path_.elements[piece.element];

  State state;
  state.time = piece.time + tau;
  state.line = lines_[piece.element];
  state.element = piece.element;
  state.programmed_feed = feeds_[piece.element];
  state.cause = piece.cause;
  if (piece.law == Law::filtered) {
    return filtered_state(state, piece, tau);
  }

  const LawPoint law = law_at(piece, tau);
  const CurvePoint at = curve_point(piece, law.q);
  state.path_length = element.s;
  if (piece.law == Law::parameter) {
    state.path_length += path_.blends[element.geometry].length_to(std::clamp(law.q, 0.0, 1.0));
  } else {
    state.path_length += std::clamp(law.q, 0.0, element.length);
  }
  const Kinematics motion = kinematics_of(at, law);
  state.position = motion.position;
  state.velocity = motion.velocity;
  state.acceleration = motion.acceleration;
  state.jerk = motion.jerk;

  if (piece.law == Law::parameter) {
    const double sigma = at.d1.norm();
    const double dsigma = at.d1.dot(at.d2) / sigma;
    const double ddsigma = (at.d2.squaredNorm() + at.d1.dot(at.d3) - dsigma * dsigma) / sigma;
    state.speed = sigma * law.v;
    state.tangential_acceleration = dsigma * law.v * law.v + sigma * law.a;
    state.tangential_jerk = ddsigma * law.v * law.v * law.v + 3 * dsigma * law.v * law.a + sigma * law.j;
  } else {
    state.speed = law.v;
    state.tangential_acceleration = law.a;
    state.tangential_jerk = law.j;
  }
  return state;
}

State Trajectory::filtered_state(State state, const Piece& piece, double tau) const {
  const PathElement& element = path_.elements[piece.element];
  const FilteredMotion& motion = motion_of(piece);
  const double start = piece.time - motion.start();
  const Kinematics at = motion.at(start + tau);
  state.position = at.position;
  state.velocity = at.velocity;
  state.acceleration = at.acceleration;
  state.jerk = at.jerk;
  state.path_length = element.s + std::min(element.length, piece.q + motion.length(start, start + tau));
  state.speed = at.velocity.norm();
  if (state.speed > 0) {
    const double along = at.acceleration.dot(at.velocity) / state.speed;
    state.tangential_acceleration = along;
    state.tangential_jerk =
        (at.jerk.dot(at.velocity) + at.acceleration.squaredNorm() - along * along) / state.speed;
  } else {
    state.tangential_acceleration = at.acceleration.norm();
    state.tangential_jerk = at.jerk.norm();
  }
  return state;
}

State Trajectory::state_at_path(double path_length) const {
  if (pieces_.empty()) {
    return state(0);
  }
  const auto& elements = path_.elements;
  const double s = std::clamp(path_length, 0.0, path_.length());
  const auto element =
      std::min(std::lower_bound(elements.begin(), elements.end(), s,
                                [](const PathElement& e, double value) { return e.s + e.length < value; }),
               elements.end() - 1);
  const auto index = static_cast<std::uint32_t>(element - elements.begin());
  const auto [first, last] =
      std::equal_range(pieces_.begin(), pieces_.end(), Piece{0, 0, 0, 0, 0, index, {}, {}},
                       [](const Piece& a, const Piece& b) { return a.element < b.element; });
  const double local = std::clamp(s - element->s, 0.0, element->length);
  const bool by_parameter = first != last && first->law == Law::parameter;
  const double q = by_parameter ? path_.blends[element->geometry].parameter_at(local) : local;
  auto piece = std::lower_bound(first, last, q, [](const Piece& p, double value) { return p.q < value; });
  if (piece != first) {
    --piece;
  }
  const auto number = static_cast<std::size_t>(piece - pieces_.begin());
  if (piece->law == Law::filtered) {
    const FilteredMotion& motion = motion_of(*piece);
    const double start = piece->time - motion.start();
    const double time = motion.time_at_length(start, piece_end(number) - motion.start(), q - piece->q);
    return state_in_piece(number, time - start);
  }
  return state_in_piece(number, law_inverse(*piece, q, piece_end(number) - piece->time));
}

double Trajectory::time_of_line(std::uint32_t line) const {
  std::size_t best = lines_.size();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i] >= line && (best == lines_.size() || lines_[i] < lines_[best])) {
      best = i;
    }
  }
  if (best == lines_.size()) {
    return duration_;
  }
  const auto piece =
      std::lower_bound(pieces_.begin(), pieces_.end(), best,
                       [](const Piece& p, std::size_t element) { return p.element < element; });
  return piece == pieces_.end() ? duration_ : piece->time;
}

}  // namespace feedscope
