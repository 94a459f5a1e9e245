#include "ui/scene/colour_map.h"

#include <algorithm>
#include <cmath>

namespace feedscope::ui {
namespace {

struct Lab {
  double lightness, a, b;
};

// All inside sRGB, as are the straight lines between them; lightness evenly spaced.
using ControlPoints = std::array<Lab, 5>;
constexpr ControlPoints ramp_on_light{Lab{20, 36, -50}, Lab{35, 4, -40}, Lab{50, -26, -12}, Lab{65, -36, 30},
                                      Lab{80, 4, 74}};
constexpr ControlPoints ramp_on_dark{Lab{38, 36, -58}, Lab{51, 0, -44}, Lab{64, -26, -14}, Lab{77, -36, 34},
                                     Lab{90, -6, 64}};
constexpr ControlPoints diverging_on_light{Lab{28, 14, -46}, Lab{52, -6, -30}, Lab{82, 0, 0}, Lab{52, 34, 40},
                                           Lab{28, 38, 36}};
constexpr ControlPoints diverging_on_dark{Lab{76, -14, -34}, Lab{60, -8, -24}, Lab{30, 0, 0}, Lab{60, 24, 34},
                                          Lab{76, 20, 56}};

/// CIE 15: Lab to XYZ under D65.
double inverse_lightness(double t) {
  constexpr double knee = 6.0 / 29.0;
  return t > knee ? t * t * t : 3 * knee * knee * (t - 4.0 / 29.0);
}

/// IEC 61966-2-1: linear light to sRGB.
double encode(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Rgb to_rgb(const Lab& lab) {
  const double fy = (lab.lightness + 16) / 116;
  const double x = 0.95047 * inverse_lightness(fy + lab.a / 500);
  const double y = inverse_lightness(fy);
  const double z = 1.08883 * inverse_lightness(fy - lab.b / 200);
  return {encode(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          encode(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          encode(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

/// Colour at `value` in [0, 1] on the polyline through `points`.
Rgb colour_along(const ControlPoints& points, double value) {
  const double position = std::clamp(value, 0.0, 1.0) * (points.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), points.size() - 2);
  const double u = position - static_cast<double>(i);
  const Lab& p = points[i];
  const Lab& q = points[i + 1];
  return to_rgb({std::lerp(p.lightness, q.lightness, u), std::lerp(p.a, q.a, u), std::lerp(p.b, q.b, u)});
}

}  // namespace

Rgb map_colour(double value, Background background) {
  return colour_along(background == Background::dark ? ramp_on_dark : ramp_on_light, value);
}

Rgb diverging_colour(double value, Background background) {
  return colour_along(background == Background::dark ? diverging_on_dark : diverging_on_light,
                      (value + 1) / 2);
}

}  // namespace feedscope::ui
