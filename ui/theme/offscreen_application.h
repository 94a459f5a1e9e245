#pragma once

#include <memory>

#include "ui/theme/theme.h"

class QApplication;

namespace feedscope::ui {

/// A QApplication without a display, unless the process already has one; with the theme, font and number
/// format of all pictures: DejaVu Sans, decimal points.
class OffscreenApplication {
 public:
  /// `pixel_ratio`: pixels of widget pictures per logical pixel; used if the process has no QApplication yet.
  explicit OffscreenApplication(ThemeKind theme = ThemeKind::light, double pixel_ratio = 1);
  ~OffscreenApplication();

 private:
  int count_ = 1;
  char name_[10] = "feedscope";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

}  // namespace feedscope::ui
