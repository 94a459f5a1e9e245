#pragma once

#include <QString>
#include <vector>

#include "core/analysis/load/load_figures.h"
#include "core/load/engagement.h"

namespace feedscope::ui {

/// How tables name an operation: "tool 1, lines 10 to 20".
QString operation_text(const Engagement& operation);
/// "Chip below its least thickness (rubbing)".
QString limit_text(LoadLimit limit);
/// What of a run has no load and why; empty if all of its cutting has one.
QString without_load_text(const LoadFigures& load);
/// "the load of 12.3 s of cutting; engagement as given, ...".
QString assumptions_text(const LoadFigures& load);
/// What is beyond each bound, a sentence each.
QStringList limits_text(const LoadFigures& load);

}  // namespace feedscope::ui
