#pragma once

#include <QStringList>

#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// Notes on facts that the numbers of a run do not show: a program for another control, other work offsets,
/// path control of the program that the model ignores, times that are not in the cycle time.
QStringList run_note_texts(const Run& run);

}  // namespace feedscope::ui
