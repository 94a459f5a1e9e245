#pragma once

#include <optional>

#include "app/asked_program.h"
#include "app/several_runs.h"
#include "ui/session/session.h"

namespace feedscope {

/// A session with its program found; none if the file name is not of a session. Prints the unknown parts of
/// the session to standard error, and whether the program has changed since. Throws InputError with the
/// reason: unusable session, missing program, an option that conflicts with a session; `more` as in
/// asked_program().
std::optional<ui::Session> asked_session(const ProgramOptions& options, std::vector<GivenOption> more);
std::optional<ui::Session> asked_session(const SeveralRunsOptions& options);

/// Reads the program of a session and simulates its runs. Throws Cancelled.
ui::ReportInput simulate_session(const ui::Session& session, Watch& watch);

}  // namespace feedscope
