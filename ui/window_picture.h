#pragma once

#include "core/analysis/run.h"
#include "ui/scene/picture.h"

namespace feedscope::ui {

/// Pictures of a run that need no display: Qt draws off screen, the 3D view in software, numbers with a
/// decimal point, so that the same run gives the same picture everywhere. They make a QApplication for
/// themselves where there is none yet.
///
/// Throw InputError if the picture is too small for what it must show.

/// The whole window, the 3D view seen from `view`.
Picture draw_window(const Run& run, PictureSize size, StandardView view);
/// Feed, acceleration and jerk over time, under a line that names the run.
Picture draw_charts(const Run& run, PictureSize size);

}  // namespace feedscope::ui
