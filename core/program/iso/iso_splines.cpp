// The part of IsoReader that reads LinuxCNC's splines: G5 (cubic), G5.1 (quadratic), G5.2 and G5.3 (NURBS).
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/program/iso/iso_reader.h"
#include "core/program/path/b_spline.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr int cubic = 50;
constexpr int quadratic = 51;
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
    const Vec3 words = programmed_axes(state_.incremental ? Vec3(Vec3::Zero()) : nurbs_.end);
    nurbs_.end = state_.incremental ? Vec3(nurbs_.end + words) : words;
    nurbs_.points.push_back(point);
    nurbs_.points.back().at = nurbs_.end;
  }
}

void IsoReader::end_nurbs() {
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
  std::vector<Eigen::Vector4d> weighted_points;
  for (const ControlPoint& point : points) {
    weighted_points.push_back(weighted(point.at, point.weight));
  }
  const std::vector<double> knots = clamped_knots(points.size(), degree);
  for (std::size_t i = degree; i < points.size(); ++i) {
    const ControlPoint& point = points[i];
    path().begin_line(point.line, point.place);
    path().program_axes();
    path().curve([&](double u) { return b_spline_place(weighted_points, knots, degree, i, u); }, knots[i],
                 knots[i + 1], point.place.column);
  }
  path().begin_line(shown_line(), place(0));
}

void IsoReader::finish() {
  if (nurbs_.points.empty()) {
    return;
  }
  report(Severity::error, "spline-words", nurbs, 0, [&] {
    return Text{fmt::format("G5.2 in line {} is not closed by G5.3", nurbs_.points.front().place.line),
                "the curve ends at its last control point"};
  });
  end_nurbs();
}

}  // namespace feedscope
