#pragma once

#include "ui/theme/type_size.h"

namespace feedscope::ui {

/// Room beside the plots [px], the same in all charts so that their plots stand in line.
inline int plot_left_margin() {
  return type_pixels(64);
}
inline constexpr int plot_right_margin = 14;

}  // namespace feedscope::ui
