#pragma once

#include <array>
#include <cstddef>

namespace feedscope::ui {

/// sRGB, each part in [0, 1].
using Rgb = std::array<double, 3>;

/// Colours of the scene: dark on light, told apart without red and green.
namespace palette {
inline constexpr Rgb background{0.984, 0.988, 0.992};
inline constexpr Rgb text{0.13, 0.17, 0.21};
inline constexpr Rgb frame{0.55, 0.60, 0.65};
inline constexpr Rgb grid{0.865, 0.885, 0.905};
inline constexpr Rgb programmed{0.56, 0.59, 0.63};
inline constexpr Rgb rapid{0.72, 0.46, 0.64};
inline constexpr Rgb blend_edge{0.10, 0.12, 0.15};
inline constexpr Rgb tool{0.84, 0.26, 0.05};
inline constexpr std::array<Rgb, 3> axes{Rgb{0.80, 0.27, 0.15}, Rgb{0.05, 0.50, 0.35}, Rgb{0.10, 0.35, 0.75}};
}  // namespace palette

inline constexpr std::size_t colour_map_size = 256;

/// Colour of a value in [0, 1], clamped: dark indigo over blue and green to gold. CIELAB lightness rises in a
/// straight line from 20 to 80, so that order survives colour blindness and grey print, and the light end
/// still shows on white.
Rgb map_colour(double value);

}  // namespace feedscope::ui
