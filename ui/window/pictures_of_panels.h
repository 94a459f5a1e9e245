#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/circularity/circular_test.h"
#include "core/analysis/compare.h"
#include "core/analysis/study/study.h"
#include "ui/language/language.h"
#include "ui/scene/picture.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

class MainWindow;
class Workbench;

/// Pictures of a run that need no display: Qt draws off screen, the 3D view in software, numbers with a
/// decimal point, so that the same run gives the same picture everywhere. They make a QApplication for
/// themselves where there is none yet.
///
/// Throw InputError if the picture is too small for what it must show.

/// What of the window is to be seen.
struct WindowLook {
  StandardView view = StandardView::iso;  ///< of the 3D view
  ThemeKind theme = ThemeKind::light;
  double pixel_ratio = 1;  ///< pixels to a unit of the size
  QString language = languages().front();
  /// What a user would do before looking; the picture waits for the simulations that follow.
  std::function<void(MainWindow&, Workbench&)> prepare = {};
};

Picture draw_window(const Run& run, PictureSize size, const WindowLook& look);
/// Feed, acceleration and jerk over time, under a line that names the run.
Picture draw_charts(const Run& run, PictureSize size);

/// Throws InputError if draw_comparison cannot show the runs of these setups in the size that is `wanted`, or
/// in any: to be known before they are simulated.
void check_comparison_size(std::span<const Setup> setups, std::optional<PictureSize> wanted);
/// Runs of a program side by side (ComparisonChart); 1280 pixels wide and as high as they need unless a size
/// is `wanted`. `assignments`: what was set for all of them.
Picture draw_comparison(const LoadedProgram& program, std::span<const ComparedRun> runs,
                        const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                        const QString& language = languages().front());
/// Throws InputError if draw_study() could not make a picture of this many runs.
void check_study_size(std::span<const Sweep> sweeps, std::size_t runs, std::optional<PictureSize> wanted);
/// A study with one sweep as curves (StudyChart), with more as maps (StudyMapPicture); as large as they need
/// unless a size is `wanted`.
Picture draw_study(const LoadedProgram& program, const Study& study,
                   const std::vector<std::string>& assignments, std::optional<PictureSize> wanted,
                   const QString& language = languages().front());

/// Circular tests of one setup as polar plots, in the format that the end of the file's name says: .png, .svg
/// or .pdf; the bytes of the file. As large as the plots need unless a size is `wanted`. Throws InputError
/// for another ending too.
std::string circular_file(const std::string& name, const Setup& setup, const std::vector<CircularTest>& tests,
                          std::optional<PictureSize> wanted, const QString& language = languages().front());

}  // namespace feedscope::ui
