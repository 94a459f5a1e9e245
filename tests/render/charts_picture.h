#pragma once

#include "core/analysis/run/run.h"
#include "ui/scene/picture.h"

namespace feedscope::test {

/// The charts in dark colours over path length, with both cursors, one curve hidden, and what the program
/// promises as another run.
ui::Picture draw_dark_charts(const Run& run, ui::PictureSize size);

}  // namespace feedscope::test
