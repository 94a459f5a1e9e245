#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double safe_height = 5;  // mm

Vector3d at(const Vector2d& p, double z) {
  return {p.x(), p.y(), z};
}

/// Safe height, above `start`, then down to `depth`.
void enter(NcWriter& nc, const Vector2d& start, double depth) {
  nc.rapid({0, 0, safe_height});
  nc.rapid(at(start, safe_height));
  nc.line(at(start, depth), 1000);
}

void leave(NcWriter& nc, const Vector2d& end) {
  nc.rapid(at(end, safe_height));
  nc.raw("M5");
  nc.raw("M30");
}

/// The pocket offset inwards: a rectangle with one sharp corner, one small and one large rounded corner and
/// one chamfer. Rounded corners keep their centre, so that their radius shrinks from pass to pass.
struct Pass {
  static constexpr double width = 200;
  static constexpr double height = 120;
  static constexpr double small_radius = 30;
  static constexpr double large_radius = 60;
  static constexpr double chamfer = 40;
  double offset = 0;

  double left() const { return offset; }
  double right() const { return width - offset; }
  double bottom() const { return offset; }
  double top() const { return height - offset; }
  double sum_on_chamfer() const { return width + height - chamfer - offset * std::sqrt(2.0); }
  Vector2d start() const { return {width / 2, bottom()}; }
};

void cut(NcWriter& nc, const Pass& pass, double depth, double feed) {
  const double small = std::max(Pass::small_radius - pass.offset, 0.0);
  const double large = std::max(Pass::large_radius - pass.offset, 0.0);
  nc.line(at({pass.right() - small, pass.bottom()}, depth), feed);
  if (small > 0) {
    nc.arc(false, at({pass.right(), pass.bottom() + small}, depth),
           {pass.right() - small, pass.bottom() + small});
  }
  const double chamfer_bottom = pass.sum_on_chamfer() - pass.right();
  const double chamfer_left = pass.sum_on_chamfer() - pass.top();
  nc.line(at({pass.right(), chamfer_bottom}, depth));
  nc.line(at({chamfer_left, pass.top()}, depth));
  nc.line(at({pass.left() + large, pass.top()}, depth));
  if (large > 0) {
    nc.arc(false, at({pass.left(), pass.top() - large}, depth), {pass.left() + large, pass.top() - large});
  }
  nc.line(at({pass.left(), pass.bottom()}, depth));
  nc.line(at(pass.start(), depth));
}

/// A bore milled by a tool of 20 mm: quarter circle in, full circle, quarter circle out.
struct Bore {
  double diameter;         ///< mm
  double approach_radius;  ///< mm
  double feed;             ///< mm/min
  std::string_view speed_lost;
  std::string_view measured;  ///< full circle
};

std::string mill(const Bore& bore) {
  constexpr double tool_radius = 10;  // mm
  constexpr double depth = -10;       // mm
  const double radius = bore.diameter / 2 - tool_radius;
  const Vector2d approach_center{radius - bore.approach_radius, 0};
  const Vector2d approach_start = approach_center - Vector2d{0, bore.approach_radius};
  const Vector2d on_bore{radius, 0};
  const Vector2d exit_end = approach_center + Vector2d{0, bore.approach_radius};

  NcWriter nc(3);
  nc.comment(fmt::format("BORE OF {} MM, TOOL OF 20 MM: QUARTER CIRCLE IN, FULL CIRCLE, QUARTER CIRCLE OUT",
                         bore.diameter));
  nc.comment(fmt::format("SHOWS: SPEED LOST WHERE CURVATURE JUMPS FROM {} MM. AFTER TAPIE 2007, SECTION 6",
                         bore.speed_lost));
  nc.comment(fmt::format("MACHINE MIKRON-UCP710; MEASURED THERE FOR THE FULL CIRCLE: {} S", bore.measured));
  nc.raw("G17 G21 G90 G94");
  nc.raw("T1 M6");
  nc.raw("S12000 M3");
  enter(nc, {0, 0}, depth);
  nc.line(at(approach_start, depth), bore.feed);
  nc.arc(false, at(on_bore, depth), approach_center);
  nc.arc(false, at(on_bore, depth), {0, 0});
  nc.arc(false, at(exit_end, depth), approach_center);
  nc.line({0, 0, depth});
  leave(nc, {0, 0});
  return nc.text();
}

}  // namespace

std::vector<Sample> tapie_bores() {
  return {{"tapie_bore.nc", mill({80, 20, 9549, "1/20 TO 1/30", "1.36"})},
          {"tapie_bore_25.nc", mill({25, 1.5, 5984, "1/1.5 TO 1/2.5", "0.53"})}};
}

Sample msaddek_pocket() {
  constexpr double tool_radius = 10;  // mm
  constexpr double pass_distance = 8;
  constexpr double feed = 15000;  // mm/min
  constexpr double depth = -10;   // mm
  constexpr int passes = 6;       // the last leaves nothing inside: 20 mm between its long sides

  NcWriter nc(3);
  nc.comment("POCKET OF 200 X 120 MM, TOOL OF 20 MM: CONCENTRIC PASSES FROM THE WALL INWARDS");
  nc.comment("SHOWS: SHARP, OBTUSE AND ROUNDED CORNERS, WHOSE RADIUS SHRINKS FROM PASS TO PASS");
  nc.comment("IN THE MANNER OF MSADDEK 2011, SECTION 3.2; MACHINE HERMLE-C800U");
  nc.raw("G17 G21 G90 G94");
  nc.raw("T1 M6");
  nc.raw("S18000 M3");
  enter(nc, Pass{tool_radius}.start(), depth);
  for (int i = 0; i < passes; ++i) {
    const Pass pass{tool_radius + i * pass_distance};
    nc.comment(i == 0 ? "PASS ALONG THE WALL" : "NEXT PASS INWARDS");
    if (i > 0) {
      nc.line(at(pass.start(), depth));
    }
    cut(nc, pass, depth, i == 0 ? feed : 0);
  }
  leave(nc, Pass{tool_radius + (passes - 1) * pass_distance}.start());
  return {"msaddek_pocket.nc", nc.text()};
}

Sample trochoidal_slot() {
  constexpr int turns = 40;
  constexpr double radius = 14;        // of the cutting half circle: slot of 40 mm, tool of 12 mm
  constexpr double corner_radius = 3;  // of the way back
  constexpr double stepover = 1.5;     // mm
  constexpr int blocks_per_half = 36;  // 5 degrees, chord error 13 um
  constexpr double feed = 3000;        // mm/min
  constexpr double depth = -10;        // mm

  NcWriter nc(3);
  nc.comment("TROCHOIDAL SLOT 40 MM WIDE, 40 TURNS, TOOL OF 12 MM");
  nc.comment("EACH TURN: HALF CIRCLE IN CUT AS SHORT BLOCKS, ARC, STRAIGHT WAY BACK, ARC, STEP FORWARD");
  nc.comment("SHOWS: WHAT THE CORNERS BETWEEN SHORT BLOCKS COST AGAINST TRUE ARCS AND LINES");
  nc.comment("IN THE MANNER OF WARD 2021, SECTION 4.1; MACHINE DMG-MORI-EVO40");
  nc.raw("G17 G21 G90 G94");
  nc.raw("T1 M6");
  nc.raw("S8000 M3");
  enter(nc, {0, -radius}, depth);
  for (int turn = 0; turn < turns; ++turn) {
    const double x = turn * stepover;
    if (turn > 0) {
      nc.line({x, -radius, depth});
    }
    for (int i = 1; i <= blocks_per_half; ++i) {
      const double angle = units::pi * (static_cast<double>(i) / blocks_per_half - 0.5);
      nc.line({x + radius * std::cos(angle), radius * std::sin(angle), depth},
              turn == 0 && i == 1 ? feed : 0);
    }
    const double back = x - corner_radius;
    const double corner_y = radius - corner_radius;
    nc.arc(false, {back, corner_y, depth}, {x, corner_y});
    nc.line({back, -corner_y, depth});
    nc.arc(false, {x, -radius, depth}, {x, -corner_y});
  }
  leave(nc, {(turns - 1) * stepover, -radius});
  return {"trochoidal_slot.nc", nc.text()};
}

}  // namespace feedscope::samples
