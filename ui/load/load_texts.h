#pragma once

#include <QString>
#include <vector>

#include "core/analysis/load/load_figures.h"
#include "core/load/engagement.h"

namespace feedscope::ui {

/// Name of an operation in tables: "tool 1, lines 10 to 20".
QString operation_text(const Engagement& operation);
/// "Chip below its least thickness (rubbing)".
QString limit_text(LoadLimit limit);
/// The cutting without a load, and why; empty if all of it has one.
QString without_load_text(const LoadFigures& load);
/// "the load of 12.3 s of cutting; engagement as given, ...".
QString assumptions_text(const LoadFigures& load);
/// The exceeded bounds, one sentence each.
QStringList limits_text(const LoadFigures& load);

}  // namespace feedscope::ui
