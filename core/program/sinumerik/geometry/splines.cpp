#include "core/program/sinumerik/geometry/splines.h"

#include <algorithm>

namespace feedscope::sinumerik {

SplinePath::Point Splines::point_of_block(const Vec3& target) const {
  SplinePath::Point point{.at = target,
                          .weight = words_.has(Address::pw) ? words_[Address::pw].value : 1,
                          .interval = {},
                          .feed = path().feed(),
                          .line = lines().shown_line(),
                          .place = place(words_.first_column("XYZ"))};
  if (words_.has(Address::pl) && words_[Address::pl].value >= 0) {
    point.interval = words_[Address::pl].value;
  }
  if (!(point.weight > 0)) {
    report(Severity::error, "spline-weight", 0, words_[Address::pw].column, [&] {
      return Text{message(NC_("core", "weight PW={} is not above zero"), point.weight),
                  NC_("core", "1 is used")};
    });
    point.weight = 1;
  }
  return point;
}

void Splines::collect(const Vec3& target) {
  const SplinePath::Point point = point_of_block(target);
  if (words_.has(Address::sd)) {
    spline_.set_degree(static_cast<int>(std::clamp(words_[Address::sd].value, 1.0, 3.0)));
  }
  const std::string_view kind = modal_.motion->name;
  if (spline_.begun() && spline_.kind() != kind) {
    finish();
  }
  if (!spline_.begun()) {
    SplinePath::Point start = point;
    start.at = path().position();
    start.weight = 1;
    spline_.begin(kind, start, last_.direction(path()));
  }
  const bool new_place = (target - spline_.last().at).norm() > same_point;
  if (new_place || kind == "BSPLINE") {
    spline_.add(point);
  }
}

void Splines::finish() {
  if (!spline_.begun()) {
    return;
  }
  const SplinePath curve = spline_;
  const double feed = path().feed();
  Vec3 direction = Vec3::Zero();
  if (modal_.motion->action == Action::line || modal_.motion->action == Action::rapid) {
    direction = targets_.target(curve.last().at) - curve.last().at;
  }
  spline_.clear();
  curve.spans(direction.norm() > same_point ? Vec3(direction.normalized()) : Vec3(Vec3::Zero()),
              [&](const ParametricCurve& span, double from, double to, const SplinePath::Point& point) {
                path().begin_line(point.line, point.place);
                path().program_axes();
                path().set_feed(point.feed);
                const Vec3 leaves = path().curve(span, from, to, point.place.column);
                last_.set_start(path().position() - leaves);
              });
  last_.set_line();
  path().begin_line(lines().shown_line(), place(0));
  path().set_feed(feed);
}

}  // namespace feedscope::sinumerik
