#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/study/compare.h"
#include "core/analysis/study/study.h"
#include "ui/language/language.h"
#include "ui/scene/picture.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

class MainWindow;
class Workbench;

/// Pictures of a run without a display: Qt draws off screen, the 3D view in software, numbers have a decimal
/// point, so that the same run gives the same picture everywhere. Creates a QApplication if there is none.
///
/// These functions throw InputError if the picture is too small for its contents.

/// Visible state of the window.
struct WindowLook {
  StandardView view = StandardView::iso;  ///< of the 3D view
  ThemeKind theme = ThemeKind::light;
  double pixel_ratio = 1;  ///< pixels per unit of the size
  QString language = languages().front();
  /// Actions of a user beforehand; the picture waits for the simulations that follow.
  std::function<void(MainWindow&, Workbench&)> prepare = {};
};

Picture draw_window(const Run& run, PictureSize size, const WindowLook& look);
/// Feed, acceleration and jerk over time, under a line with the name of the run.
Picture draw_charts(const Run& run, PictureSize size);

/// Throws InputError if draw_comparison() cannot show the runs of these setups in the size `wanted`, or in
/// any size. Called before they are simulated.
void check_comparison_size(std::span<const Setup> setups, std::optional<PictureSize> wanted);
/// Runs of a program side by side (ComparisonChart); 1280 pixels wide and as high as needed, unless a size is
/// `wanted`. `assignments`: settings common to all runs.
Picture draw_comparison(const LoadedProgram& program, std::span<const ComparedRun> runs,
                        const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                        const QString& language = languages().front());
/// Throws InputError if draw_study() cannot show this many runs.
void check_study_size(std::span<const Sweep> sweeps, std::size_t runs, std::optional<PictureSize> wanted);
/// A study with one sweep as curves (StudyChart), with more as maps (StudyMapPicture); as large as needed,
/// unless a size is `wanted`.
Picture draw_study(const LoadedProgram& program, const Study& study,
                   const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                   const QString& language = languages().front());

/// Circular tests of one setup as polar plots. Returns the bytes of a file in the format of the name's
/// ending: .png, .svg or .pdf. As large as the plots need, unless a size is `wanted`. Also throws InputError
/// for another ending.
std::string circular_file(const std::string& name, const Setup& setup, const std::vector<CircularTest>& tests,
                          std::optional<PictureSize> wanted, const QString& language = languages().front());

}  // namespace feedscope::ui
