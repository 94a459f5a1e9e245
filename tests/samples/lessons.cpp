#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int decimals = 4;

Vector3d direction(double degrees) {
  const double angle = units::from_deg(degrees);
  return {std::cos(angle), std::sin(angle), 0};
}

NcWriter begin(const std::string& what, const std::string& shows) {
  NcWriter nc(decimals);
  nc.comment(what);
  nc.comment("SHOWS: " + shows);
  nc.raw("G17 G21 G90 G94");
  return nc;
}

/// Every corner from rest to rest and half of its turn on each side of X, so that all of them lie the same
/// way to the axes and differ in nothing but their angle.
Sample corners() {
  NcWriter nc =
      begin("CORNERS OF 15, 30, 60, 90, 120 AND 150 DEGREES BETWEEN LEGS OF 20 MM, EACH FROM REST TO REST",
            "WHAT THE ANGLE OF A CORNER AND THE CONTOUR TOLERANCE COST");
  constexpr double leg = 20;
  constexpr double apart = 30;
  nc.raw("F3000");
  Vector3d start = Vector3d::Zero();
  for (const double turn : {15.0, 30.0, 60.0, 90.0, 120.0, 150.0}) {
    nc.rapid(start);
    const Vector3d corner = start + leg * direction(-turn / 2);
    nc.line(corner);
    nc.line(corner + leg * direction(turn / 2));
    start.y() += apart;
  }
  nc.raw("M30");
  return {"lesson_corners.nc", nc.text()};
}

/// From the middle of a side once around, so that every corner is passed in motion.
Sample polygon(bool stops) {
  NcWriter nc = begin("ONCE AROUND AN OCTAGON WITH SIDES OF 20 MM AT 6000 MM/MIN, FROM THE MIDDLE OF A SIDE",
                      stops ? "THE TIME OF AN EXACT STOP, WITH AND WITHOUT A WINDOW"
                            : "CORNERS OF 45 DEGREES THAT ARE PASSED WITHOUT A STOP");
  if (stops) {
    nc.raw("G61");
  }
  constexpr double side = 20;
  constexpr int corners = 8;
  constexpr double turn = 360.0 / corners;
  Vector3d place = Vector3d::Zero();
  for (int i = 0; i <= corners; ++i) {
    place += (i == 0 || i == corners ? side / 2 : side) * direction(i * turn);
    nc.line(place, i == 0 ? 6000 : 0);
  }
  nc.raw("M30");
  return {stops ? "lesson_polygon_stops.nc" : "lesson_polygon.nc", nc.text()};
}

/// Out and back: the reversals are exact stops on every control.
Sample lines() {
  NcWriter nc =
      begin("LINES OF 100 MM AT 3 AND AT 12 M/MIN, OF 10 AND OF 1 MM AT 12 M/MIN, EACH FROM REST TO REST",
            "WHEN JERK DECIDES AND WHEN ACCELERATION DOES");
  nc.line({100, 0, 0}, 3000);
  nc.line({0, 0, 0}, 12000);
  nc.line({10, 0, 0}, 12000);
  nc.line({9, 0, 0}, 12000);
  nc.raw("M30");
  return {"lesson_lines.nc", nc.text()};
}

/// Full circles of 20 mm entered in four ways; `entry` draws the way in and out of one around `center`.
Sample approaches() {
  NcWriter nc = begin(
      "CIRCLES OF RADIUS 20 MM ENTERED STRAIGHT ONTO THE WALL, ALONG THE TANGENT, BY ARCS OF 10 AND OF 16 MM",
      "WHAT A JUMP OF CURVATURE COSTS, AND THAT AN APPROACH ARC HELPS WHERE ITS RADIUS IS NEAR THAT OF THE "
      "BORE");
  constexpr double radius = 20;
  constexpr double apart = 60;
  nc.raw("F6000");
  const auto circle = [&](const Vector2d& center) {
    nc.arc(false, {center.x() + radius, center.y(), 0}, center);
  };
  nc.rapid({0, 0, 0});
  nc.line({radius, 0, 0});
  circle({0, 0});
  nc.line({0, 0, 0});

  Vector2d center(apart, 0);
  nc.rapid({center.x() + radius, -radius, 0});
  nc.line({center.x() + radius, 0, 0});
  circle(center);
  nc.line({center.x() + radius, radius, 0});

  for (const double arc : {10.0, 16.0}) {
    center.x() += apart;
    const Vector2d arc_center = center + Vector2d(radius - arc, 0);
    nc.rapid({center.x(), center.y(), 0});
    nc.line({arc_center.x(), -arc, 0});
    nc.arc(false, {center.x() + radius, 0, 0}, arc_center);
    circle(center);
    nc.arc(false, {arc_center.x(), arc, 0}, arc_center);
    nc.line({center.x(), center.y(), 0});
  }
  nc.raw("M30");
  return {"lesson_approach.nc", nc.text()};
}

Sample row(double block, double length, int feed, const std::string& name, const std::string& shows) {
  NcWriter nc =
      begin(fmt::format("STRAIGHT ROW OF {} MM IN BLOCKS OF {} MM AT {} MM/MIN", length, block, feed), shows);
  const int count = static_cast<int>(std::lround(length / block));
  for (int i = 1; i <= count; ++i) {
    nc.line({i * block, 0, 0}, i == 1 ? feed : 0);
  }
  nc.raw("M30");
  return {name, nc.text()};
}

Sample wave() {
  NcWriter nc = begin("ONE WAVE OF 100 MM, 4 MM HIGH, IN CHORDS OF 0.1 MM AT 9600 MM/MIN",
                      "WHAT COMPACTION OF SHORT BLOCKS GAINS AND COSTS");
  constexpr int count = 1000;
  constexpr double length = 100;
  constexpr double height = 4;
  for (int i = 1; i <= count; ++i) {
    const double x = length * i / count;
    nc.line({x, height / 2 * (1 - std::cos(2 * units::pi * x / length)), 0}, i == 1 ? 9600 : 0);
  }
  nc.raw("M30");
  return {"lesson_short_wave.nc", nc.text()};
}

/// Four waves, as all programs of lesson_dense*.
constexpr double waves_length = 100;

Vector2d wave_at(double x) {
  return {x, 4 * std::sin(2 * units::pi * x / 25)};
}

Vector2d wave_direction(double x) {
  return Vector2d(1, 4 * 2 * units::pi / 25 * std::cos(2 * units::pi * x / 25)).normalized();
}

/// Ends of the longest pieces of the waves of which `leaves(from, to)` is at most `error` [mm]; of at most
/// `longest` along X.
template <typename Leaves>
std::vector<double> wave_pieces(double error, double longest, Leaves leaves) {
  constexpr double fine = 0.02;
  std::vector<double> ends;
  for (double x = 0; x < waves_length;) {
    double step = fine;
    while (step < longest && leaves(x, x + step + fine) <= error) {
      step += fine;
    }
    x = std::min(x + step, waves_length);
    ends.push_back(x);
  }
  return ends;
}

double chord_leaves_wave(double from, double to) {
  double largest = 0;
  const Vector2d start = wave_at(from);
  const double slope = (wave_at(to).y() - start.y()) / (to - from);
  for (int i = 1; i < 20; ++i) {
    const double x = from + (to - from) * i / 20;
    largest =
        std::max(largest, std::abs(wave_at(x).y() - start.y() - slope * (x - from)) / std::hypot(1, slope));
  }
  return largest;
}

/// Chords as long as `chord_error` [mm] allows, as a CAM system writes them.
Sample waves(double chord_error, const std::string& name, const std::string& shows) {
  NcWriter nc =
      begin(fmt::format("FOUR WAVES OF 25 MM, 8 MM HIGH, WITH A CHORD ERROR OF {:.0f} UM AT 6000 MM/MIN",
                        1000 * chord_error),
            shows);
  bool first = true;
  for (const double x : wave_pieces(chord_error, 3, chord_leaves_wave)) {
    nc.line({x, wave_at(x).y(), 0}, first ? 6000 : 0);
    first = false;
  }
  nc.raw("M30");
  return {name, nc.text()};
}

/// Two arcs from one point of the waves to another that are tangent to the waves there and to each other
/// where they meet: the biarc whose control points are equally far from its ends.
struct Biarc {
  std::array<Vector2d, 2> centers;
  Vector2d middle;
};

Biarc wave_biarc(double from, double to) {
  const Vector2d start = wave_at(from);
  const Vector2d end = wave_at(to);
  const Vector2d along = wave_direction(from);
  const Vector2d along_end = wave_direction(to);
  const Vector2d chord = end - start;
  const double both = chord.dot(along + along_end);
  const double turn = 2 * (1 - along.dot(along_end));
  const double reach = chord.squaredNorm() / (both + std::sqrt(both * both + turn * chord.squaredNorm()));
  Biarc biarc;
  biarc.middle = (start + reach * along + end - reach * along_end) / 2;
  const auto center = [&](const Vector2d& point, const Vector2d& direction) -> Vector2d {
    const Vector2d left(-direction.y(), direction.x());
    const Vector2d to_middle = biarc.middle - point;
    return point + to_middle.squaredNorm() / (2 * left.dot(to_middle)) * left;
  };
  biarc.centers = {center(start, along), center(end, along_end)};
  return biarc;
}

double biarc_leaves_wave(double from, double to) {
  constexpr double half_wave = 12.5;
  if (std::floor(from / half_wave) < std::floor(to / half_wave - 1e-9)) {
    return waves_length;  // the curvature changes its sign on the way
  }
  const Biarc biarc = wave_biarc(from, to);
  double largest = 0;
  for (int i = 1; i < 20; ++i) {
    const Vector2d point = wave_at(from + (to - from) * i / 20);
    const Vector2d& center = biarc.centers[point.x() < biarc.middle.x() ? 0 : 1];
    largest = std::max(largest, std::abs((point - center).norm() - (biarc.middle - center).norm()));
  }
  return largest;
}

/// The same waves in tangent arcs.
Sample wave_arcs() {
  NcWriter nc = begin("FOUR WAVES OF 25 MM, 8 MM HIGH, IN TANGENT ARCS WITHIN 5 UM AT 6000 MM/MIN",
                      "WHAT ARCS MAKE OF A CURVE THAT CAM COULD WRITE AS LINES OR AS A SPLINE");
  constexpr double error = 0.005;
  constexpr double longest = 12.5;
  nc.raw("F6000");
  double from = 0;
  for (const double to : wave_pieces(error, longest, biarc_leaves_wave)) {
    const Biarc biarc = wave_biarc(from, to);
    const bool crest = wave_at((from + to) / 2).y() > 0;
    nc.arc(crest, {biarc.middle.x(), biarc.middle.y(), 0}, biarc.centers[0]);
    nc.arc(crest, {to, wave_at(to).y(), 0}, biarc.centers[1]);
    from = to;
  }
  nc.raw("M30");
  return {"lesson_dense_arcs.nc", nc.text()};
}

/// The same waves as a spline through 64 points; straight at both ends, as the waves are there.
Sample wave_spline() {
  NcWriter nc(decimals);
  nc.raw("; Four waves of 25 mm, 8 mm high, as one spline through 64 points at 6000 mm/min");
  nc.raw("; Shows: what a spline makes of a curve that CAM could write as lines or as arcs");
  nc.raw("G17 G710 G90 G94");
  nc.raw("G1 X0 Y0 F6000");
  nc.raw("BNAT ENAT CSPLINE");
  constexpr int points = 64;
  for (int i = 1; i <= points; ++i) {
    const Vector2d point = wave_at(waves_length * i / points);
    nc.raw(fmt::format("X{:.4f} Y{:.4f}", point.x(), point.y()));
  }
  nc.raw("M30");
  return {"lesson_dense_spline.mpf", nc.text()};
}

Sample right_angle() {
  NcWriter nc = begin("ONE RIGHT ANGLE BETWEEN TWO LEGS OF 20 MM AT 3000 MM/MIN",
                      "BLENDS THAT ARE INSERTED AGAINST FILTERS THAT ROUND");
  nc.line({20, 0, 0}, 3000);
  nc.line({20, 20, 0});
  nc.raw("M30");
  return {"lesson_right_angle.nc", nc.text()};
}

/// The axes come to rest before the slanted line and behind it.
Sample drives() {
  NcWriter nc = begin("LINES OF 60 MM ALONG X AND AT 30 DEGREES, THEN A RIGHT ANGLE, AT 6 M/MIN",
                      "HOW FAR AXES ARE BEHIND, WHAT THAT DOES TO A SLANTED LINE AND IN A CORNER");
  constexpr double leg = 60;
  nc.raw("F6000");
  Vector3d place = leg * direction(0);
  nc.line(place);
  nc.raw("G4 P0.5");
  place += leg * direction(30);
  nc.line(place);
  nc.raw("G4 P0.5");
  for (const double angle : {0.0, 90.0}) {
    place += leg * direction(angle);
    nc.line(place);
  }
  nc.raw("M30");
  return {"lesson_drives.nc", nc.text()};
}

/// Counter-clockwise inside a pocket under M3: climb milling, and the cutter stays in the stock at corners.
/// The tool comes in by a full line before the corners with blends, and leaves by a slow one.
Sample chip() {
  NcWriter nc = begin("THE WALL OF A POCKET OF 70 X 50 MM, CUTTER OF 10 MM, EXACT STOPS, A SLOW LINE",
                      "WHAT A SLOW-DOWN DOES TO CHIP THICKNESS AND CUTTING FORCE");
  constexpr double left = -20;
  constexpr double right = 40;
  constexpr double low = -12;
  constexpr double high = 28;
  constexpr double above = 5;
  constexpr double depth = -5;
  constexpr double plunge = 600;
  constexpr double feed = 2700;
  nc.raw("T1 M6");
  nc.raw("S9000 M3");
  nc.rapid({left, low, above});
  nc.line({left, low, depth}, plunge);
  nc.line({right, low, depth}, feed);
  nc.line({right, high, depth});
  nc.line({left, high, depth});
  nc.line({left, low, depth});
  nc.raw("G61");
  nc.line({right, low, depth});
  nc.line({right, high, depth});
  nc.raw("G64");
  nc.line({left + right, high, depth}, feed / 5);
  nc.rapid({left + right, high, above});
  nc.raw("M5");
  nc.raw("M30");
  return {"lesson_chip.nc", nc.text()};
}

/// A straight line on which the tool swings past the vertical, half a degree beside it; the part tilted by
/// `tilt` degrees about X.
Sample past_the_axis(double tilt, const std::string& name, const std::string& shows) {
  NcWriter nc =
      begin("A LINE OF 80 MM, THE TOOL SWINGS FROM -15 TO 15 DEGREES, HALF A DEGREE BESIDE THE AXIS OF C" +
                (tilt > 0 ? fmt::format(", PART TILTED BY {:g} DEGREES", tilt) : std::string()),
            shows);
  constexpr int blocks = 160;
  constexpr double length = 80;
  const double side = std::tan(units::from_deg(0.5));
  const double turned = units::from_deg(tilt);
  const auto vector = [&](int i) {
    const double swing = std::tan(units::from_deg(15)) * (2.0 * i / blocks - 1);
    const Vector3d tool = Vector3d(swing, side, 1).normalized();
    return fmt::format("I{:.6f} J{:.6f} K{:.6f}", tool.x(),
                       std::cos(turned) * tool.y() + std::sin(turned) * tool.z(),
                       std::cos(turned) * tool.z() - std::sin(turned) * tool.y());
  };
  nc.raw("G0 X-40 Y0 Z20");
  nc.raw("G43.5 H1 X-40 Y0 Z0 " + vector(0));
  nc.raw("G1 F3000");
  for (int i = 1; i <= blocks; ++i) {
    nc.raw(fmt::format("X{:.1f} {}", length * i / blocks - length / 2, vector(i)));
  }
  nc.raw("G49");
  nc.raw("M30");
  return {name, nc.text()};
}

/// The same corners at two programmed feeds.
Sample zigzag(int feed) {
  NcWriter nc =
      begin(fmt::format("ZIGZAG OF 40 LEGS OF 2 MM WITH RIGHT ANGLES, PROGRAMMED AT {} MM/MIN", feed),
            "WHAT CAM PROMISES AND WHAT THE CONTROL DOES");
  constexpr int legs = 40;
  constexpr double leg = 2;
  Vector3d place = Vector3d::Zero();
  for (int i = 0; i < legs; ++i) {
    place += leg * direction(i % 2 == 0 ? 45 : -45);
    nc.line(place, i == 0 ? feed : 0);
  }
  nc.raw("M30");
  return {fmt::format("lesson_zigzag_{}.nc", feed), nc.text()};
}

}  // namespace

std::vector<Sample> lesson_programs() {
  return {corners(),
          polygon(false),
          polygon(true),
          lines(),
          approaches(),
          row(0.1, 100, 9600, "lesson_short_blocks.nc",
              "BLOCKS SHORTER THAN THE FEED COVERS IN ONE INTERPOLATION PERIOD"),
          wave(),
          waves(0.005, "lesson_dense.nc", "WHAT A COMPRESSOR MAKES OF DENSE SHORT BLOCKS"),
          waves(0.002, "lesson_dense_2.nc", "FINER CHORDS THAN THE CONTROL NEEDS"),
          waves(0.02, "lesson_dense_20.nc", "CHORDS AS COARSE AS A FINISHING TOLERANCE"),
          waves(0.05, "lesson_dense_rough.nc", "CHORDS COARSER THAN THE TOLERANCE"),
          wave_arcs(),
          wave_spline(),
          row(0.5, 200, 6000, "lesson_lookahead.nc", "A HORIZON OF TOO FEW BLOCKS"),
          right_angle(),
          drives(),
          chip(),
          past_the_axis(0, "lesson_singular.nc", "A ROTARY AXIS NEAR ITS SINGULAR POSITION"),
          past_the_axis(10, "lesson_singular_tilted.nc", "THE SAME CUT AWAY FROM THE SINGULAR POSITION"),
          zigzag(3000),
          zigzag(6000)};
}

}  // namespace feedscope::samples
