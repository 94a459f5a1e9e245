#pragma once

#include <string>
#include <vector>

#include "app/run_options.h"
#include "ui/window/main_window.h"

namespace feedscope {

/// What the window begins with, as it was asked for on the command line. Nothing is said where nothing was
/// asked: the window then decides as it does without a command line.
class WindowStart {
 public:
  /// Throws InputError naming what is wrong: an option beside a session or a lesson, one of the program
  /// without a program, an unreadable program, an unusable setup. `lesson`: id or file, "" for none.
  /// `traces`: files to compare with the run. `unlocked`: lessons show their run before a prediction is
  /// written.
  WindowStart(const RunOptions& options, const std::string& lesson, std::vector<std::string> traces = {},
              bool unlocked = false);

  /// What the first run is set up as.
  const ui::SetupState& setup() const { return setup_; }
  /// Shows it in a window whose first run is of setup(). A session that was left behind is offered where
  /// nothing is opened.
  void show(ui::MainWindow& window, ui::Workbench& model) const;

 private:
  std::string file_;
  std::filesystem::path lesson_;
  std::vector<std::string> traces_;
  ReadOptions reading_;
  bool unlocked_ = false;
  bool run_asked_ = false;  ///< a machine, model, tolerance or setting
  ui::SetupState setup_;
};

}  // namespace feedscope
