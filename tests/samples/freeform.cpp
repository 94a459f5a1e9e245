#include <array>
#include <cmath>

#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

constexpr double width = 90;           // along the rows [mm]
constexpr double depth = 60;           // across the rows [mm]
constexpr double row_distance = 0.2;   // mm
constexpr double chord_error = 0.002;  // mm

double square(double v) {
  return v * v;
}

/// Height of the tool path [mm]: a dome, a steep winding step, a dent and a fine wave.
double height(double x, double y) {
  const double dome = 11 * std::exp(-(square(x - 27) + square(y - 32)) / 140);
  const double step = 5 * std::tanh((x - 60 + 8 * std::sin(y / 11)) / 2.5);
  const double dent = -4 * std::exp(-(square(x - 76) + square(y - 20)) / 30);
  const double wave = 0.25 * std::sin(x / 2.2) * std::cos(y / 9);
  return dome - step + dent + wave;
}

/// The longest of a few steps along the row whose chord stays close enough to the surface.
double step_length(double x, double y, double direction) {
  for (const double step : {0.5, 0.4, 0.3, 0.25, 0.2, 0.15}) {
    const double to = x + direction * step;
    const double sag = height(x + direction * step / 2, y) - (height(x, y) + height(to, y)) / 2;
    const double slope = (height(to, y) - height(x, y)) / step;
    if (std::abs(sag) <= chord_error * std::sqrt(1 + square(slope))) {
      return step;
    }
  }
  return 0.1;
}

}  // namespace

Sample freeform_finish() {
  constexpr double feed = 6000;  // mm/min
  const int rows = static_cast<int>(std::lround(depth / row_distance)) + 1;

  NcWriter nc(3);
  nc.comment("FINISHING OF A FREE-FORM SURFACE OF 90 X 60 MM: ZIGZAG, ROWS 0.2 MM APART, SHORT BLOCKS");
  nc.comment("SHOWS: FEED LOST ON STEEP WALLS, IN CURVED REGIONS AND AT THE ENDS OF ROWS");
  nc.comment("HEIGHTS ARE THOSE OF THE TOOL POINT; CHORD ERROR 2 UM. MACHINE DMG-MORI-EVO40");
  nc.raw("G17 G21 G90 G94");
  nc.raw("T1 M6");
  nc.raw("S18000 M3");
  nc.rapid({0, 0, 20});
  nc.line({0, 0, height(0, 0)}, 2000);
  for (int row = 0; row < rows; ++row) {
    const double y = row * row_distance;
    const double direction = row % 2 == 0 ? 1 : -1;
    double x = row % 2 == 0 ? 0 : width;
    const double end = width - x;
    if (row > 0) {
      nc.line({x, y, height(x, y)});
    }
    while (x != end) {
      const double step = step_length(x, y, direction);
      x = direction * (end - x) <= step ? end : x + direction * step;
      nc.line({x, y, height(x, y)}, row == 0 && x == step ? feed : 0);
    }
  }
  nc.raw("G0 Z20");
  nc.raw("M5");
  nc.raw("M30");
  return {"freeform_finish.nc", nc.text()};
}

}  // namespace feedscope::samples
