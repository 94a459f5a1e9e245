#pragma once

#include <memory>

#include "ui/theme/theme.h"

class QApplication;

namespace feedscope::ui {

/// A QApplication without display, unless the process has one already; with the theme, the font and the
/// numbers that pictures have everywhere: DejaVu Sans, decimal points.
class OffscreenApplication {
 public:
  /// `pixel_ratio`: pixels of widgets' pictures to a logical one; counts where the process has no
  /// QApplication yet.
  explicit OffscreenApplication(ThemeKind theme = ThemeKind::light, double pixel_ratio = 1);
  ~OffscreenApplication();

 private:
  int count_ = 1;
  char name_[10] = "feedscope";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

}  // namespace feedscope::ui
