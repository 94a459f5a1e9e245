#include "core/models/optimal/filtered_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace feedscope {
namespace {

constexpr std::size_t curves_for_any = 200'000;
constexpr std::size_t curves_a_block = 2000;

/// Least and largest share of a filter time between two checks of the motion, unless one pulse fills the
/// filters: then it turns by this at most between them [rad].
constexpr double min_filter_share = 0.25;
constexpr double max_filter_share = 0.5;
constexpr double max_turn = 0.5;
/// Shorter blocks are not separate elements: the curvature between such near places would be rounding [mm].
constexpr double min_block = 1e-4;
/// Nearer places count as the same [mm].
constexpr double same_place = 1e-10;
/// Length within which a turn by more than a curve may turn is a standstill [mm].
constexpr double turned_back = 1e-7;
/// Share of the largest speed that counts as a standstill.
constexpr double still = 1e-9;

/// Permitted deviations of a curve in its middle: distance as a share of the allowed one, because it may be
/// larger elsewhere; direction [rad]; curvature as a share of itself, or of the axes' limit at the feed.
constexpr double distance_share = 0.25;
constexpr double direction_off = 1e-3;
constexpr double curvature_off = 0.005;
constexpr double curvature_of_limit = 2e-3;

/// Least cosine of a curve's turn; a larger turn within `turned_back` [mm] turns back there.
constexpr double min_cosine = 0.5;

constexpr int deepest = 60;

/// Largest curvature of a knot times the chord of an adjacent curve. Curves that follow the motion turn less.
/// Next to a standstill a curve can be accepted for its shortness alone, and the curvature of the motion is
/// unbounded there.
constexpr double max_bend = 2;

/// Lowers the curvature of `knot` to `most` [1/mm]; true if it was larger.
bool bend_at_most(double most, CourseKnot& knot) {
  const double curvature = knot.curvature.norm();
  if (!(curvature > most)) {
    return false;
  }
  knot.curvature *= most / curvature;
  return true;
}

}  // namespace

FilteredPath::Place FilteredPath::place_at(double t) {
  const PulseTrain& train = motion_->train();
  const Kinematics at = walk_.motion_at(train, t);
  const double speed = at.velocity.norm();
  Place place{t, {0, at.position, Vec3::Zero(), Vec3::Zero()}, speed <= still * train.largest_feed};
  if (!place.stands) {
    place.knot.tangent = at.velocity / speed;
    const Vec3 across = at.acceleration - place.knot.tangent * at.acceleration.dot(place.knot.tangent);
    constexpr double digits = 4;
    const double rounding = digits * FilterWalk::velocity_rounding * train.largest_feed / train.filter_time;
    if (across.norm() > rounding) {
      place.knot.curvature = across / (speed * speed);
      place.turn_rate = across.norm() / speed;
    }
  }
  return place;
}

void FilteredPath::lay() {
  const BlendedPath& path = run_.path();
  const std::vector<Piece>& pieces = run_.pieces();
  std::size_t piece = 0;
  for (std::uint32_t e = 0; e < path.size(); ++e) {
    block_ = path.segment(e);
    feed_ = run_.feed_of(e);
    const std::size_t first = piece;
    while (piece < pieces.size() && pieces[piece].element == e) {
      ++piece;
    }
    if (path.kind(e) == ElementKind::dwell) {
      builder_.add_segment(block_);
      continue;
    }
    if (motion_ != &run_.motion_of(e)) {
      begin_motion(run_.motion_of(e));
    }
    const bool ends =
        e + 1 == path.size() || path.kind(e + 1) == ElementKind::dwell || &run_.motion_of(e + 1) != motion_;
    if (piece > first) {
      const double end = run_.piece_end(piece - 1) - motion_->start();
      follow(run_.pieces()[first].time - motion_->start(), end);
      end_block(end, false);
    }
    if (ends) {
      end_block(motion_->duration(), true);
    }
  }
}

void FilteredPath::begin_motion(const FilteredMotion& motion) {
  motion_ = &motion;
  last_ = place_at(0);
  last_.stands = true;
  knots_.assign(1, last_.knot);
}

void FilteredPath::follow(double from, double to) {
  const double filter_time = motion_->filter_time();
  for (double t = from; t < to;) {
    const double knot = walk_.next_knot(motion_->train(), t);
    double end = std::clamp(knot, t + min_filter_share * filter_time, t + max_filter_share * filter_time);
    double count = 1;
    if (walk_.is_settled()) {
      end = std::min(knot, to);
      count = std::max(std::ceil((end - t) * place_at(t).turn_rate / max_turn), 1.0);
    }
    const double looks = end < to ? count : count - 1;  // end_block() checks the end
    for (double i = 1; i <= looks; ++i) {
      follow_to(t + i / count * (end - t));
    }
    t = end;
  }
}

void FilteredPath::follow_to(double time) {
  const Place to = place_at(time);
  if ((to.knot.position - last_.knot.position).norm() > min_block) {
    fit_to(to, 0);
  }
}

void FilteredPath::end_block(double time, bool at_rest) {
  Place to = place_at(time);
  to.stands = to.stands || at_rest;
  const bool is_short = (to.knot.position - last_.knot.position).norm() <= min_block;
  const bool has_curves = knots_.size() > 1;
  if (is_short && has_curves) {  // not next to another knot
    knots_.pop_back();
    last_ = before_;
  }
  if (to.stands || has_curves || !is_short) {
    fit_to(to, 0);
  }
  if (!to.stands && knots_.size() > 1 && last_.time == to.time) {
    end_element();
  }
}

/// Lays curves from the end of the last one to `to`.
void FilteredPath::fit_to(const Place& to, int depth) {
  const Place middle = place_at((last_.time + to.time) / 2);
  CourseKnot from = last_.knot;
  CourseKnot end = to.knot;
  const Vec3 chord = end.position - from.position;
  if (last_.stands) {
    from.tangent = chord.normalized();
  }
  if (to.stands) {
    end.tangent = chord.normalized();
  }
  const double size =
      std::max((middle.knot.position - from.position).norm(), (end.position - middle.knot.position).norm());
  const bool goes_on = from.tangent.dot(end.tangent) > min_cosine && !middle.stands;
  if (depth == deepest || size <= turned_back || (size <= error_ && goes_on) ||
      (goes_on && is_close(from, middle, end, to.time))) {
    put(to);
    return;
  }
  fit_to(middle, depth + 1);
  fit_to(to, depth + 1);
}

bool FilteredPath::is_close(CourseKnot from, const Place& middle, CourseKnot to, double time) {
  from.s = 0;
  to.s = course_length(from, to);
  const CourseSpan span(from, to);
  const double curvature =
      std::max({from.curvature.norm(), middle.knot.curvature.norm(), to.curvature.norm()});
  const auto passes = [&](const CourseKnot& knot, double share) {
    double s = share * span.length();
    if (!(span.distance(knot.position, s) <= distance_share * error_)) {
      return false;
    }
    const CurvePoint at = span.at(s);
    return (at.d1 - knot.tangent).norm() <= direction_off &&
           (at.d2 - knot.curvature).norm() <=
               curvature_off * curvature + curvature_of_limit * min_acceleration_ / (feed_ * feed_);
  };
  return passes(middle.knot, 0.5) && passes(place_at((last_.time + middle.time) / 2).knot, 0.25) &&
         passes(place_at((middle.time + time) / 2).knot, 0.75);
}

/// Appends the curve to `place`; where the motion stops there, or turns back, the element ends.
void FilteredPath::put(const Place& place) {
  const Vec3 chord = place.knot.position - last_.knot.position;
  CourseKnot knot = place.knot;
  bool turns_back = false;
  if (chord.norm() > same_place) {
    const Vec3 direction = chord.normalized();
    if (!last_.stands && knots_.back().tangent.dot(direction) <= min_cosine) {
      end_element();
      last_.stands = true;
    }
    if (last_.stands) {
      knots_.back().tangent = direction;
      knots_.back().curvature = Vec3::Zero();
    }
    turns_back = !place.stands && knots_.back().tangent.dot(knot.tangent) <= min_cosine;
    if (place.stands || turns_back) {
      knot.tangent = direction;
      knot.curvature = Vec3::Zero();
    }
    bend_at_most(max_bend / chord.norm(), knot);
    if (bend_at_most(max_bend / chord.norm(), knots_.back()) && knots_.size() > 1) {
      const CourseKnot& before = knots_[knots_.size() - 2];
      knots_.back().s = before.s + course_length(before, knots_.back());
    }
    knot.s = knots_.back().s + course_length(knots_.back(), knot);
    knots_.push_back(knot);
    const std::size_t most = curves_for_any + curves_a_block * run_.path().size();
    if (++curves_ > most) {
      throw InputError(
          message(NC_("core",
                      "setting path: the path of ward needs more than {} curves to be approximated within {} "
                      "mm, up to line {}; choose the path of another model"),
                  most, error_, run_.path().programmed()->segments[block_].line));
    }
  } else {
    turns_back = !place.stands && !last_.stands && knots_.back().tangent.dot(knot.tangent) <= min_cosine;
  }
  if (chord.norm() > same_place || place.stands || turns_back) {
    before_ = last_;
    last_ = place;
  }
  if (place.stands || turns_back) {
    end_element();
    knots_.assign(1, place.knot);
  }
}

void FilteredPath::end_element() {
  if (knots_.size() > 1) {
    builder_.add_fitted(block_, knots_);
  }
  knots_.assign(1, last_.knot);
  knots_.front().s = 0;
}

}  // namespace feedscope
