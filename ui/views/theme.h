#pragma once

namespace feedscope::ui {

/// Fusion style with a neutral light palette, the same on every desktop and off screen. Needs a QApplication.
void apply_theme();

}  // namespace feedscope::ui
