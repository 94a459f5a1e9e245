#include <algorithm>
#include <cmath>

#include "tests/samples/essid.h"
#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

constexpr double feed = 3000;  // mm/min

Eigen::Vector2d spline(double u) {
  return {100 * u, 100 * (3 * u * u * u - 4 * u * u + u)};
}

// The cubic deviates most from a chord where its tangent is parallel to it: roots of Y'(u) = slope.
double chord_error(double from, double to) {
  const Eigen::Vector2d start = spline(from);
  const Eigen::Vector2d chord = (spline(to) - start).normalized();
  const double slope = chord.y() / chord.x();
  const double root = std::sqrt(16 - 9 * (1 - slope));
  double error = 0;
  for (const double u : {(4 - root) / 9, (4 + root) / 9}) {
    if (from < u && u < to) {
      const Eigen::Vector2d d = spline(u) - start;
      error = std::max(error, std::abs(d.x() * chord.y() - d.y() * chord.x()));
    }
  }
  return error;
}

}  // namespace

std::vector<double> spline_parameters(double tolerance) {
  constexpr double step = 1.0 / 1024;
  std::vector<double> parameters{0};
  while (parameters.back() < 1) {
    const double from = parameters.back();
    double within = from;
    while (within < 1 && chord_error(from, std::min(within + step, 1.0)) <= tolerance) {
      within = std::min(within + step, 1.0);
    }
    double beyond = std::min(within + step, 1.0);
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = (within + beyond) / 2;
      (chord_error(from, middle) <= tolerance ? within : beyond) = middle;
    }
    parameters.push_back(within);
  }
  return parameters;
}

Sample essid_table1() {
  NcWriter nc(3);
  nc.comment("FOUR LINES WITH CORNERS OF 30, 90 AND 60 DEGREES: POINTS OF ESSID 2019, TABLE 1");
  nc.comment("SHOWS: SPEED THROUGH A CORNER BLEND AGAINST THE ANGLE OF THE CORNER");
  nc.comment("MACHINE SPINNER-MVC850, MODEL ESSID, CONTOUR TOLERANCE 0.1 MM");
  nc.raw("G17 G21 G90 G94");
  nc.line({7.071, 7.071, 0}, feed);
  nc.line({9.659, 16.73, 0});
  nc.line({19.318, 14.142, 0});
  nc.line({26.389, 21.213, 0});
  nc.raw("M30");
  return {"essid_table1.nc", nc.text()};
}

Sample essid_spline() {
  NcWriter nc(6);
  nc.comment("CUBIC X = 100 U, Y = 300 U^3 - 400 U^2 + 100 U IN CHORDS OF 0.5 MM ERROR, AFTER ESSID 2019");
  nc.comment("SHOWS: WHERE A COARSE TESSELLATION COSTS TIME");
  nc.comment(
      "MACHINE SPINNER-MVC850, MODEL ESSID, CONTOUR TOLERANCE 0.1 MM; SIMULATED THERE 3.063 S, MEASURED "
      "3.024 S");
  nc.raw("G17 G21 G90 G94");
  const std::vector<double> parameters = spline_parameters(0.5);
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const Eigen::Vector2d p = spline(parameters[i]);
    nc.line({p.x(), p.y(), 0}, i == 1 ? feed : 0);
  }
  nc.raw("M30");
  return {"essid_spline.nc", nc.text()};
}

}  // namespace feedscope::samples
