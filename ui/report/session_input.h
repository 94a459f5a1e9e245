#pragma once

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope::ui {

/// Input of pictures, sheet and report from a session: its runs with their names and colours, its camera,
/// charts, annotations and identification. `results`: of its runs, in order, null
/// for a failed one. The caller sets title, author, date
/// and commands.
ReportInput report_input(const Session& session, const std::vector<std::shared_ptr<const ShownRun>>& results);

}  // namespace feedscope::ui
