#pragma once

#include <QStringList>

#include "ui/workbench/shown_run.h"

namespace feedscope::ui {

/// What the numbers of a run do not say by themselves, in sentences: a program for another control, other
/// work offsets, path control of the program that the model ignores, what the cycle time leaves out.
QStringList run_note_texts(const Run& run);

}  // namespace feedscope::ui
