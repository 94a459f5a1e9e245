#pragma once

namespace feedscope::ui {

/// Room beside the plots [px], the same in all charts so that their plots stand in line.
inline constexpr int plot_left_margin = 64;
inline constexpr int plot_right_margin = 14;

}  // namespace feedscope::ui
