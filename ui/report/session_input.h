#pragma once

#include "ui/report/report_input.h"
#include "ui/session/session.h"

namespace feedscope::ui {

/// What pictures, sheet and report of a session show: its runs with their names and colours, its camera,
/// charts, annotations and what was identified. `results`: of its runs, in their order, null
/// of one that could not be made. Title, author, date
/// and commands are left to the caller.
ReportInput report_input(const Session& session, const std::vector<std::shared_ptr<const ShownRun>>& results);

}  // namespace feedscope::ui
