#pragma once

#include <QString>

#include "ui/report/report_input.h"

namespace feedscope::ui {

// Breakdown of the current run's time and helpful changes, as HTML, as in `explain` and the panel Time.

/// `input` with ReportInput::time. `with_changes`: including helpful changes, each simulated. Throws
/// Cancelled if `progress` is cancelled.
ReportInput with_time_report(ReportInput input, bool with_changes, Progress* progress = nullptr);

/// Cycle time compared with the programmed time, its parts, and operations by tool or comment; empty if
/// nothing takes time. `input` as of with_time_report(), here and below.
QString time_use_block(const ReportInput& input);
/// The places with the largest loss, grouped by common properties; empty without a loss.
QString time_places_block(const ReportInput& input);
/// The changes with the largest gain; empty if none was tried.
QString time_changes_block(const ReportInput& input);

}  // namespace feedscope::ui
