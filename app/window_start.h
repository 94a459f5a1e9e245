#pragma once

#include <string>
#include <vector>

#include "app/run_options.h"
#include "ui/window/main_window.h"

namespace feedscope {

/// First contents of the window, from the command line. Anything not requested there is left to the window.
class WindowStart {
 public:
  /// Throws InputError with the reason: an option that conflicts with a session or a lesson, a program option
  /// without a program, an unreadable program, an unusable setup. `lesson`: id or file, "" for none.
  /// `traces`: files to compare with the run. `unlocked`: lessons show their run before a prediction is
  /// written.
  WindowStart(const RunOptions& options, const std::string& lesson, std::vector<std::string> traces = {},
              bool unlocked = false);

  /// Setup of the first run.
  const ui::SetupState& setup() const { return setup_; }
  /// Shows it in a window whose first run has setup(). If nothing is opened, the window offers an unsaved
  /// session left by an earlier process.
  void show(ui::MainWindow& window, ui::Workbench& model) const;

 private:
  std::string file_;
  std::filesystem::path lesson_;
  std::vector<std::string> traces_;
  ReadOptions reading_;
  bool unlocked_ = false;
  bool run_asked_ = false;  ///< by a machine, model, tolerance or setting
  ui::SetupState setup_;
};

}  // namespace feedscope
