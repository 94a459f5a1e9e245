#include "core/program/iso/geometry/splines.h"

#include <algorithm>
#include <cmath>

#include "core/program/path/b_spline.h"
#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr int cubic_code = 50;
constexpr int quadratic_code = 51;
constexpr int fanuc_nurbs = 62;
constexpr int nurbs = 52;
constexpr int nurbs_end = 53;
constexpr std::size_t min_nurbs_order = 3;

}  // namespace

void Splines::begin(const GCode& code, const Word& word) {
  if (code.number == nurbs_end) {
    if (nurbs_.points.empty()) {
      report(Severity::error, "spline-words", nurbs_end, word.column, [] {
        return Text{NC_("core", "G5.3 without G5.2"), NC_("core", "it is skipped")};
      });
    }
    end_nurbs();
    modal_.motion = MotionMode::none;
    return;
  }
  if (code.number == fanuc_nurbs) {
    end_nurbs();
    if (dialect() == Dialect::linuxcnc && (words_.has('Q') || !words_.has('K'))) {
      report(Severity::error, "spline-words", 'Q', word.column, [] {
        return Text{NC_("core", "G6.2 as LinuxCNC has it (weights P, no knots K) is not supported"),
                    NC_("core", "positions are skipped up to the next G0 to G3; write G5.2 and G5.3")};
      });
      modal_.motion = MotionMode::unread;
      return;
    }
  }
  const bool goes_on = modal_.motion == MotionMode::spline && modal_.spline_code == code.number;
  modal_.motion = MotionMode::spline;
  if (!goes_on) {
    modal_.spline_code = code.number;
    has_tangent_ = false;
  }
}

Vec3 Splines::offset_words(char first, char second) const {
  return {length_or(first, 0), length_or(second, 0), 0};
}

bool Splines::lacks_words(char first, char second) {
  if (words_.has(first) || words_.has(second)) {
    return false;
  }
  report(Severity::error, "spline-words", modal_.spline_code, words_.first_column("XYZ"), [&] {
    return Text{message(NC_("core", "{} without {} and {}"), g_name(modal_.spline_code), first, second),
                straight_instead};
  });
  path().line(targets_.target());
  has_tangent_ = false;
  return true;
}

bool Splines::moves_without_axes() const {
  return words_.has('P') || (modal_.spline_code == fanuc_nurbs && words_.has('K'));
}

void Splines::run() {
  switch (modal_.spline_code) {
    case cubic_code:
      cubic();
      break;
    case quadratic_code:
      quadratic();
      break;
    case fanuc_nurbs:
      add_fanuc_control_point();
      break;
    default:
      add_control_point();
      break;
  }
}

void Splines::cubic() {
  const bool goes_on = has_tangent_ && !words_.has_any("IJ");
  if (lacks_words('P', 'Q') || (!goes_on && lacks_words('I', 'J'))) {
    return;
  }
  const Vec3 start = path().position();
  const Vec3 end = targets_.target();
  const Vec3 rise((end - start).z() * Vec3::UnitZ());
  const Vec3 first = start + rise / 3 + (goes_on ? tangent_ : offset_words('I', 'J'));
  const Vec3 second = end - rise / 3 + offset_words('P', 'Q');
  tangent_ = -offset_words('P', 'Q');
  has_tangent_ = true;
  write_curve([&](double t) -> CurvePlace {
    const double s = 1 - t;
    return {s * s * s * start + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * end,
            3 * (s * s * (first - start) + 2 * s * t * (second - first) + t * t * (end - second))};
  });
}

void Splines::quadratic() {
  if (lacks_words('I', 'J')) {
    return;
  }
  const Vec3 start = path().position();
  const Vec3 end = targets_.target();
  const Vec3 middle = start + (end - start).z() / 2 * Vec3::UnitZ() + offset_words('I', 'J');
  write_curve([&](double t) -> CurvePlace {
    const double s = 1 - t;
    return {s * s * start + 2 * s * t * middle + t * t * end,
            2 * (s * (middle - start) + t * (end - middle))};
  });
}

void Splines::write_curve(const ParametricCurve& curve) const {
  path().curve(curve, 0, 1, words_.first_column("XYZIJPQ"));
}

void Splines::add_control_point() {
  const bool names_place = words_.has_any("XY");
  const double weight = words_.value_or('P', names_place ? 0 : 1);
  if (!(weight > 0) && names_place) {
    report(Severity::error, "spline-words", nurbs, words_.column_or('P', words_.first_column("XY")), [] {
      return Text{NC_("core", "a control point of G5.2 without a weight above zero"),
                  NC_("core", "1 is used; write P with the weight")};
    });
  }
  const ControlPoint point = control_point(path().position(), weight > 0 ? weight : 1);
  if (nurbs_.points.empty()) {
    nurbs_ = {};
    nurbs_.points.push_back(point);
    nurbs_.points.back().weight = names_place ? 1 : point.weight;
    nurbs_.end = point.at;
  }
  if (words_.has('L') && words_['L'].value > static_cast<double>(min_nurbs_order)) {
    const double most = max_spline_degree + 1;
    if (words_['L'].value > most) {
      report(Severity::error, "spline-words", 'L', words_['L'].column, [&] {
        return Text{message(NC_("core", "order L{} of G5.2 is above {}"), words_['L'].value, most),
                    message(NC_("core", "{} is taken"), most)};
      });
    }
    nurbs_.order = static_cast<std::size_t>(std::min(words_['L'].value, most));
  }
  if (names_place) {
    nurbs_.end = targets_.target_from(nurbs_.end);
    nurbs_.points.push_back(point);
    nurbs_.points.back().at = nurbs_.end;
  }
}

/// G6.2 P order K knot X Y Z R weight; K X Y Z R; ... and as many blocks with K alone as the order demands.
void Splines::add_fanuc_control_point() {
  constexpr std::size_t min_order = 2;
  if (nurbs_.points.empty()) {
    nurbs_ = {};
    nurbs_.order = 4;
    nurbs_.end = path().position();
    if (words_.has('P')) {
      const double order = words_['P'].value;
      const bool fits = order >= min_order && order <= max_spline_degree + 1 && order == std::floor(order);
      if (!fits) {
        report(Severity::error, "spline-words", 'P', words_['P'].column, [&] {
          return Text{message(NC_("core", "order P{} of G6.2 is not from {} to {}"), order, min_order,
                              max_spline_degree + 1),
                      NC_("core", "4 is taken")};
        });
      }
      nurbs_.order = fits ? static_cast<std::size_t>(order) : nurbs_.order;
    }
  }
  if (words_.has('K')) {
    nurbs_.knots.push_back(words_['K'].value);
  }
  if (words_.has_any("XYZ")) {
    nurbs_.end = targets_.target_from(nurbs_.end);
    const double weight = words_.value_or('R', 1);
    if (!(weight > 0)) {
      report(Severity::error, "spline-words", 'R', words_['R'].column, [] {
        return Text{NC_("core", "a control point of G6.2 without a weight above zero"),
                    NC_("core", "1 is used; write R with the weight")};
      });
    }
    nurbs_.points.push_back(control_point(nurbs_.end, weight > 0 ? weight : 1));
  }
}

Splines::ControlPoint Splines::control_point(const Vec3& at, double weight) const {
  return {at, weight, lines().shown_line(), lines().place(0)};
}

void Splines::end_fanuc_nurbs() {
  const std::vector<ControlPoint> points = std::move(nurbs_.points);
  const std::vector<double> knots = std::move(nurbs_.knots);
  nurbs_.points.clear();
  nurbs_.knots.clear();
  const std::size_t degree = nurbs_.order - 1;
  const bool sound = points.size() > degree && knots.size() == points.size() + nurbs_.order &&
                     std::is_sorted(knots.begin(), knots.end()) && knots[degree] < knots[points.size()];
  path().begin_line(points.back().line, points.back().place);
  path().program_axes();
  if (!sound) {
    machining_.log.add(Severity::error, "spline-words", fanuc_nurbs, points.back().place, [&] {
      return Text{message(NC_("core", "G6.2 of order {} with {} control points and {} knots K"), nurbs_.order,
                          points.size(), knots.size()),
                  NC_("core",
                      "a straight line to the last point is used instead; write as many non-decreasing K as "
                      "points and order together")};
    });
    path().line(points.back().at);
  } else {
    write_nurbs(points, knots);
  }
  path().begin_line(lines().shown_line(), lines().place(0));
}

void Splines::write_nurbs(const std::vector<ControlPoint>& points, const std::vector<double>& knots) const {
  const std::size_t degree = knots.size() - points.size() - 1;
  std::vector<Eigen::Vector4d> weighted_points;
  for (const ControlPoint& point : points) {
    weighted_points.push_back(weighted(point.at, point.weight));
  }
  bool begun = false;
  for (std::size_t i = degree; i < points.size(); ++i) {
    if (!(knots[i] < knots[i + 1])) {
      continue;
    }
    const auto span = [&](double u) { return b_spline_place(weighted_points, knots, degree, i, u); };
    path().begin_line(points[i].line, points[i].place);
    path().program_axes();
    if (!begun && (span(knots[i]).point - path().position()).norm() > same_point) {
      path().line(span(knots[i]).point);
    }
    begun = true;
    path().curve(span, knots[i], knots[i + 1], points[i].place.column);
  }
}

void Splines::end_nurbs() {
  if (!nurbs_.points.empty() && modal_.spline_code == fanuc_nurbs) {
    end_fanuc_nurbs();
    return;
  }
  const std::vector<ControlPoint> points = std::move(nurbs_.points);
  nurbs_.points.clear();
  if (points.empty()) {
    return;
  }
  const std::size_t degree = nurbs_.order - 1;
  if (points.size() <= degree) {
    report(Severity::error, "spline-words", 'n', points.back().place.column, [&] {
      return Text{message(NC_("core", "G5.2 with {} control points is too short for order {}"), points.size(),
                          nurbs_.order),
                  NC_("core", "a straight line to the last one is used instead")};
    });
    path().line(points.back().at);
    return;
  }
  write_nurbs(points, clamped_knots(points.size(), degree));
  path().begin_line(lines().shown_line(), lines().place(0));
}

void Splines::finish() {
  if (nurbs_.points.empty()) {
    return;
  }
  if (modal_.spline_code == fanuc_nurbs) {
    end_nurbs();
    return;
  }
  report(Severity::error, "spline-words", nurbs, 0, [&] {
    return Text{
        message(NC_("core", "G5.2 in line {} is not closed by G5.3"), nurbs_.points.front().place.line),
        NC_("core", "the curve ends at its last control point")};
  });
  end_nurbs();
}

}  // namespace feedscope::iso
