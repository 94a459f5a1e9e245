#pragma once

#include <QString>

#include "ui/report/report_input.h"

namespace feedscope::ui {

// Where the time of the current run goes and what would help, as HTML: what `explain` and the panel Time say.

/// The same with ReportInput::time. `with_changes`: also what would help, each change simulated. Throws
/// Cancelled if `progress` is cancelled.
ReportInput with_time_report(ReportInput input, bool with_changes, Progress* progress = nullptr);

/// The cycle time against the programmed time, what it consists of, and operations by tool or comment; empty
/// where nothing takes time. `input` as of with_time_report(), here and below.
QString time_use_block(const ReportInput& input);
/// The places that lose most by what they have in common; empty where no time is lost.
QString time_places_block(const ReportInput& input);
/// The changes that gain most; empty where none was tried.
QString time_changes_block(const ReportInput& input);

}  // namespace feedscope::ui
