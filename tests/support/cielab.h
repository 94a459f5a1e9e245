#pragma once

#include <array>
#include <cmath>

namespace feedscope::test {

/// sRGB, linear light or CIELAB.
using ColourTriple = std::array<double, 3>;

/// IEC 61966-2-1: one part of an sRGB colour to linear light, both in [0, 1].
inline double to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

inline ColourTriple to_linear(const ColourTriple& rgb) {
  return {to_linear(rgb[0]), to_linear(rgb[1]), to_linear(rgb[2])};
}

/// CIE 15: linear light to Lab under D65.
inline ColourTriple to_lab(const ColourTriple& linear) {
  const auto lightness = [](double t) {
    constexpr double knee = 6.0 / 29.0;
    return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29.0;
  };
  const auto& [r, g, b] = linear;
  const double x = lightness((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = lightness(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = lightness((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIE 1976 distance of two Lab colours.
inline double lab_distance(const ColourTriple& a, const ColourTriple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace feedscope::test
