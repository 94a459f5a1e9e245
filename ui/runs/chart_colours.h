#pragma once

#include <QColor>

namespace feedscope::ui {

inline constexpr QColor grid_color(0xe3, 0xe6, 0xea);
inline constexpr QColor axis_color(0x8a, 0x90, 0x98);
inline constexpr QColor text_color(0x33, 0x38, 0x3e);

}  // namespace feedscope::ui
