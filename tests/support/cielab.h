#pragma once

#include <algorithm>
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

/// Linear light to what is left of it.
using ColourVision = std::array<ColourTriple, 3>;

/// All of it, then without one kind of cones each: Machado, Oliveira and Fernandes 2009, severity 1.
inline constexpr std::array<ColourVision, 4> colour_visions{
    ColourVision{ColourTriple{1, 0, 0}, ColourTriple{0, 1, 0}, ColourTriple{0, 0, 1}},
    ColourVision{ColourTriple{0.152286, 1.052583, -0.204868}, ColourTriple{0.114503, 0.786281, 0.099216},
                 ColourTriple{-0.003882, -0.048116, 1.051998}},
    ColourVision{ColourTriple{0.367322, 0.860646, -0.227968}, ColourTriple{0.280085, 0.672501, 0.047413},
                 ColourTriple{-0.011820, 0.042940, 0.968881}},
    ColourVision{ColourTriple{1.255528, -0.076749, -0.178779}, ColourTriple{-0.078411, 0.930809, 0.147602},
                 ColourTriple{0.004733, 0.691367, 0.303900}}};

/// An sRGB colour as it is seen, in CIELAB.
inline ColourTriple seen_lab(const ColourTriple& colour, const ColourVision& vision) {
  const ColourTriple light = to_linear(colour);
  ColourTriple left;
  std::ranges::transform(vision, left.begin(), [&](const ColourTriple& row) {
    return std::clamp(row[0] * light[0] + row[1] * light[1] + row[2] * light[2], 0.0, 1.0);
  });
  return to_lab(left);
}

}  // namespace feedscope::test
