#pragma once

#include "ui/theme/type_size.h"

namespace feedscope::ui {

/// Margin left of the plots [px], equal in all charts so that the plots align.
inline int plot_left_margin() {
  return type_pixels(64);
}
inline constexpr int plot_right_margin = 14;

}  // namespace feedscope::ui
