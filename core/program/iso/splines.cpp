// The part of IsoReader that reads LinuxCNC's splines: G5 (cubic), G5.1 (quadratic), G5.2 and G5.3 (NURBS),
// and Fanuc's G6.2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/program/iso/iso_reader.h"
#include "core/program/path/b_spline.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr int cubic = 50;
constexpr int quadratic = 51;
constexpr int fanuc_nurbs = 62;
constexpr int nurbs = 52;
constexpr int nurbs_end = 53;
constexpr std::size_t least_nurbs_order = 3;
constexpr std::string_view straight_instead = "a straight line to the end is taken instead";

}  // namespace

void IsoReader::begin_spline(const GCode& code, const Word& word) {
  if (code.number == nurbs_end) {
    if (nurbs_.points.empty()) {
      report(Severity::error, "spline-words", nurbs_end, word.column, [] {
        return Text{"G5.3 without a G5.2 before it", "it is left out"};
      });
    }
    end_nurbs();
    state_.motion = MotionMode::none;
    return;
  }
  if (code.number == fanuc_nurbs) {
    end_nurbs();
    if (dialect_ == Dialect::linuxcnc && (words_.has('Q') || !words_.has('K'))) {
      report(Severity::error, "spline-words", 'Q', word.column, [] {
        return Text{"G6.2 as LinuxCNC has it (weights P, no knots K) is not supported",
                    "positions are skipped up to the next G0 to G3; write G5.2 and G5.3"};
      });
      state_.motion = MotionMode::unread;
      return;
    }
  }
  const bool goes_on = state_.motion == MotionMode::spline && state_.spline.code == code.number;
  state_.motion = MotionMode::spline;
  if (!goes_on) {
    state_.spline = {.code = code.number};
  }
}

Vec3 IsoReader::offset_words(char first, char second) const {
  const auto value = [&](char letter) { return words_.has(letter) ? state_.to_mm(words_[letter].value) : 0; };
  return {value(first), value(second), 0};
}

bool IsoReader::lacks_spline_words(char first, char second) {
  if (words_.has(first) || words_.has(second)) {
    return false;
  }
  report(Severity::error, "spline-words", state_.spline.code, words_.first_column("XYZ"), [&] {
    return Text{fmt::format("{} without {} and {}", g_name(state_.spline.code), first, second),
                std::string(straight_instead)};
  });
  path().line(target_of_block());
  state_.spline.has_tangent = false;
  return true;
}

void IsoReader::run_spline() {
  switch (state_.spline.code) {
    case cubic:
      cubic_spline();
      break;
    case quadratic:
      quadratic_spline();
      break;
    case fanuc_nurbs:
      add_fanuc_control_point();
      break;
    default:
      add_control_point();
      break;
  }
}

void IsoReader::cubic_spline() {
  const bool goes_on = state_.spline.has_tangent && !words_.has_any("IJ");
  if (lacks_spline_words('P', 'Q') || (!goes_on && lacks_spline_words('I', 'J'))) {
    return;
  }
  const Vec3 start = path().position();
  const Vec3 end = target_of_block();
  const Vec3 rise((end - start).z() * Vec3::UnitZ());
  const Vec3 first = start + rise / 3 + (goes_on ? state_.spline.tangent : offset_words('I', 'J'));
  const Vec3 second = end - rise / 3 + offset_words('P', 'Q');
  state_.spline.tangent = -offset_words('P', 'Q');
  state_.spline.has_tangent = true;
  write_curve([&](double t) -> CurvePlace {
    const double s = 1 - t;
    return {s * s * s * start + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * end,
            3 * (s * s * (first - start) + 2 * s * t * (second - first) + t * t * (end - second))};
  });
}

void IsoReader::quadratic_spline() {
  if (lacks_spline_words('I', 'J')) {
    return;
  }
  const Vec3 start = path().position();
  const Vec3 end = target_of_block();
  const Vec3 middle = start + (end - start).z() / 2 * Vec3::UnitZ() + offset_words('I', 'J');
  write_curve([&](double t) -> CurvePlace {
    const double s = 1 - t;
    return {s * s * start + 2 * s * t * middle + t * t * end,
            2 * (s * (middle - start) + t * (end - middle))};
  });
}

void IsoReader::write_curve(const ParametricCurve& curve) {
  path().curve(curve, 0, 1, words_.first_column("XYZIJPQ"));
}

Vec3 IsoReader::target_from(const Vec3& place) const {
  return state_.incremental ? Vec3(place + programmed_axes(Vec3::Zero())) : programmed_axes(place);
}

void IsoReader::add_control_point() {
  const bool names_place = words_.has_any("XY");
  const double weight = words_.has('P') ? words_['P'].value : names_place ? 0 : 1;
  if (!(weight > 0) && names_place) {
    report(Severity::error, "spline-words", nurbs,
           words_.has('P') ? words_['P'].column : words_.first_column("XY"), [] {
             return Text{"a control point of G5.2 without a weight above zero",
                         "1 is taken; write P with the weight"};
           });
  }
  const ControlPoint point{path().position(), weight > 0 ? weight : 1, shown_line(), place(0)};
  if (nurbs_.points.empty()) {
    nurbs_ = {};
    nurbs_.points.push_back(point);
    nurbs_.points.back().weight = names_place ? 1 : point.weight;
    nurbs_.end = point.at;
  }
  if (words_.has('L') && words_['L'].value > static_cast<double>(least_nurbs_order)) {
    const double most = most_spline_degree + 1;
    if (words_['L'].value > most) {
      report(Severity::error, "spline-words", 'L', words_['L'].column, [&] {
        return Text{fmt::format("order L{} of G5.2 is above {}", words_['L'].value, most),
                    fmt::format("{} is taken", most)};
      });
    }
    nurbs_.order = static_cast<std::size_t>(std::min(words_['L'].value, most));
  }
  if (names_place) {
    nurbs_.end = target_from(nurbs_.end);
    nurbs_.points.push_back(point);
    nurbs_.points.back().at = nurbs_.end;
  }
}

/// G6.2 P order K knot X Y Z R weight; K X Y Z R; ... and as many blocks with K alone as the order says.
void IsoReader::add_fanuc_control_point() {
  constexpr std::size_t least_order = 2;
  if (nurbs_.points.empty()) {
    nurbs_ = {};
    nurbs_.order = 4;
    nurbs_.end = path().position();
    if (words_.has('P')) {
      const double order = words_['P'].value;
      const bool fits = order >= least_order && order <= most_spline_degree + 1 && order == std::floor(order);
      if (!fits) {
        report(Severity::error, "spline-words", 'P', words_['P'].column, [&] {
          return Text{fmt::format("order P{} of G6.2 is not from {} to {}", order, least_order,
                                  most_spline_degree + 1),
                      "4 is taken"};
        });
      }
      nurbs_.order = fits ? static_cast<std::size_t>(order) : nurbs_.order;
    }
  }
  if (words_.has('K')) {
    nurbs_.knots.push_back(words_['K'].value);
  }
  if (words_.has_any("XYZ")) {
    nurbs_.end = target_from(nurbs_.end);
    const double weight = words_.has('R') ? words_['R'].value : 1;
    if (!(weight > 0)) {
      report(Severity::error, "spline-words", 'R', words_['R'].column, [] {
        return Text{"a control point of G6.2 without a weight above zero",
                    "1 is taken; write R with the weight"};
      });
    }
    nurbs_.points.push_back({nurbs_.end, weight > 0 ? weight : 1, shown_line(), place(0)});
  }
}

void IsoReader::end_fanuc_nurbs() {
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
    log().add(Severity::error, "spline-words", fanuc_nurbs, points.back().place, [&] {
      return Text{
          fmt::format("G6.2 of order {} with {} control points and {} knots K", nurbs_.order, points.size(),
                      knots.size()),
          "a straight line to the last point is taken instead; write as many K that do not fall as points "
          "and order together"};
    });
    path().line(points.back().at);
  } else {
    write_nurbs(points, knots);
  }
  path().begin_line(shown_line(), place(0));
}

void IsoReader::write_nurbs(const std::vector<ControlPoint>& points, const std::vector<double>& knots) {
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

void IsoReader::end_nurbs() {
  if (!nurbs_.points.empty() && state_.spline.code == fanuc_nurbs) {
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
      return Text{
          fmt::format("G5.2 with {} control points is too short for order {}", points.size(), nurbs_.order),
          "a straight line to the last one is taken instead"};
    });
    path().line(points.back().at);
    return;
  }
  write_nurbs(points, clamped_knots(points.size(), degree));
  path().begin_line(shown_line(), place(0));
}

void IsoReader::finish() {
  if (nurbs_.points.empty() || state_.spline.code == fanuc_nurbs) {
    end_nurbs();
    return;
  }
  report(Severity::error, "spline-words", nurbs, 0, [&] {
    return Text{fmt::format("G5.2 in line {} is not closed by G5.3", nurbs_.points.front().place.line),
                "the curve ends at its last control point"};
  });
  end_nurbs();
}

}  // namespace feedscope
