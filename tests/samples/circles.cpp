#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int decimals = 6;

Vector2d direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

Vector3d flat(const Vector2d& p) {
  return {p.x(), p.y(), 0};
}

/// Full circles around the origin, one for every feed of Tapie 2007, table 2, each from rest to rest.
Sample circles(double radius, std::string_view file_name, std::string_view result) {
  NcWriter nc(decimals);
  nc.comment(
      fmt::format("FULL CIRCLES OF RADIUS {} MM AT 6, 9, 12 AND 24 M/MIN: TAPIE 2007, TABLE 2", radius));
  nc.comment("SHOWS: THE FEED THAT THE CONTROL ALLOWS ON AN ARC, WHATEVER IS PROGRAMMED");
  nc.comment(fmt::format("MACHINE MIKRON-UCP710, MODEL TAPIE; MEASURED THERE {} M/MIN", result));
  nc.raw("G17 G21 G90 G94");
  const Vector3d start{radius, 0, 0};
  nc.rapid(start);
  for (const int feed : {6000, 9000, 12000, 24000}) {
    nc.raw(fmt::format("F{}", feed));
    nc.arc(false, start, {0, 0});
    nc.raw("G4 P0.5");
  }
  nc.raw("M30");
  return {std::string(file_name), nc.text()};
}

struct Spiral {
  double step;  ///< of the radius, 10 to 30 mm [mm]
  int arcs_per_turn;
  double inclination;  ///< direction in which the first arc begins [degrees]
  double feed;         ///< mm/min
};

void cut(NcWriter& nc, const Spiral& spiral) {
  constexpr double first_radius = 10;
  constexpr double last_radius = 30;
  const double sweep = 2 * units::pi / spiral.arcs_per_turn;
  double angle = units::from_deg(spiral.inclination);
  Vector2d center{0, 0};
  nc.rapid(flat(first_radius * direction(angle)));
  nc.raw(fmt::format("F{}", spiral.feed));
  for (double radius = first_radius; radius <= last_radius; radius += spiral.step) {
    angle += sweep;
    nc.arc(false, flat(center + radius * direction(angle)), center);
    center -= spiral.step * direction(angle);
  }
}

Sample quarter_spiral(int inclination, std::string_view crossing) {
  NcWriter nc(decimals);
  nc.comment(
      fmt::format("SPIRAL OF QUARTER CIRCLES, RADII 10 TO 30 MM BY 2 MM, INCLINED BY {} DEGREES: TAPIE 2007, "
                  "FIGURES 13 AND 16",
                  inclination));
  nc.comment("SHOWS: SPEED AT A CHANGE OF CURVATURE AGAINST ITS DIRECTION; ARCS TOO SHORT FOR A STEADY FEED");
  nc.comment(
      fmt::format("MACHINE MIKRON-UCP710, MODEL TAPIE; MEASURED THERE FROM 14 TO 16 MM: {} M/MIN", crossing));
  nc.raw("G17 G21 G90 G94");
  cut(nc, {2, 4, static_cast<double>(inclination), 12000});
  nc.raw("M30");
  return {fmt::format("tapie_quarter_spiral_{}.nc", inclination), nc.text()};
}

}  // namespace

std::vector<Sample> tapie_circles() {
  return {circles(2.5, "tapie_circle_2_5.nc", "2.01"),
          circles(30, "tapie_circle_30.nc", "6.01, 9.01, 10.53, 10.53")};
}

std::vector<Sample> tapie_spirals() {
  NcWriter nc(decimals);
  nc.comment("SPIRAL OF HALF CIRCLES, RADII 10 TO 30 MM BY 5 MM: TAPIE 2007, FIGURE 13");
  nc.comment(
      "SHOWS: SPEED LOST AT EVERY CHANGE OF CURVATURE; THE SMALLEST ARC STAYS BELOW THE PROGRAMMED FEED");
  nc.comment("MACHINE MIKRON-UCP710, MODEL TAPIE; MEASURED THERE ON THE FIRST ARC: 5.06 M/MIN");
  nc.raw("G17 G21 G90 G94");
  cut(nc, {5, 2, 0, 6000});
  nc.raw("M30");
  return {{"tapie_half_spiral.nc", nc.text()},
          quarter_spiral(0, "4.92"),
          quarter_spiral(30, "5.29"),
          quarter_spiral(45, "5.86")};
}

}  // namespace feedscope::samples
