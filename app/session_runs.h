#pragma once

#include <optional>

#include "app/asked_program.h"
#include "app/several_runs.h"
#include "ui/session/session.h"

namespace feedscope {

/// A session whose program is there, by the name of a file; none if the file is no session. Says on standard
/// error what of it is not known and whether the program has changed since. Throws InputError naming what is
/// wrong: unusable session, missing program, an option that a session has of its own; `more` as of
/// asked_program().
std::optional<ui::Session> asked_session(const ProgramOptions& options, std::vector<GivenOption> more);
std::optional<ui::Session> asked_session(const SeveralRunsOptions& options);

/// Reads the program of a session and simulates its runs. Throws Cancelled.
ui::ReportInput simulate_session(const ui::Session& session, Watch& watch);

}  // namespace feedscope
