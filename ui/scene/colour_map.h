#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace feedscope::ui {

/// sRGB, each part in [0, 1].
using Rgb = std::array<double, 3>;

inline constexpr std::size_t colour_map_size = 256;

/// Background of the scene: colours of lines must contrast with it.
enum class Background : std::uint8_t { light, dark };

/// Colour of a value in [0, 1], clamped: dark indigo over blue and green to gold. CIELAB lightness rises
/// linearly from 20 to 80, so that the order survives colour blindness and grey print, and the light end is
/// visible on white. On dark the same hues, 18 lighter throughout.
Rgb map_colour(double value, Background background = Background::light);

/// Colour of a value in [-1, 1], clamped: blue below zero, grey at zero, orange above, equally far from grey
/// on both sides. The ends are dark on a light background and light on a dark one.
Rgb diverging_colour(double value, Background background = Background::light);

}  // namespace feedscope::ui
