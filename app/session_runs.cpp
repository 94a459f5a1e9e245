#include "app/session_runs.h"

#include <fmt/format.h>

#include "app/trace_files.h"
#include "core/base/error.h"
#include "ui/report/session_input.h"
#include "ui/session/session_file.h"

namespace feedscope {
namespace {

void refuse_options(const ProgramOptions& options, const std::vector<GivenOption>& more) {
  std::vector<GivenOption> given = given_of(options);
  given.insert(given.begin(), more.begin(), more.end());
  for (const auto& [option, is_given] : given) {
    if (is_given) {
      throw InputError(
          fmt::format("{} cannot be combined with session '{}', which has its own; give the NC program "
                      "instead, or change the session in the window",
                      option, options.file));
    }
  }
}

}  // namespace

std::optional<ui::Session> asked_session(const SeveralRunsOptions& options) {
  return asked_session(options, {{"--machine", !options.machines.empty()},
                                 {"--model", !options.models.empty()},
                                 {"--tolerance", !options.tolerances.empty()},
                                 {"--set", !options.set.empty()}});
}

std::optional<ui::Session> asked_session(const ProgramOptions& options, std::vector<GivenOption> more) {
  if (!ui::is_session_file(options.file)) {
    return std::nullopt;
  }
  refuse_options(options, more);
  ui::ReadSession read = ui::read_session_file(options.file);
  for (const QString& note : read.notes) {
    fmt::print(stderr, "feedscope: note: {}: {}\n", options.file, note.toStdString());
  }
  const std::filesystem::path& program = read.session.program;
  const std::filesystem::path& tools = read.session.reading.tool_table;
  if (!std::filesystem::exists(program)) {
    throw InputError(
        fmt::format("the program of session '{}' was not found: '{}'; restore it, or open the "
                    "session in the window and select it",
                    options.file, program.string()));
  }
  if (!tools.empty() && !std::filesystem::exists(tools)) {
    throw InputError(
        fmt::format("the tool table of session '{}' was not found: '{}'; restore it, or open the "
                    "session in the window and choose another in File > Reading > Program import options",
                    options.file, tools.string()));
  }
  if (!read.session.program_hash.isEmpty() && ui::hash_of(program) != read.session.program_hash) {
    fmt::print(stderr,
               "feedscope: note: '{}' has changed since session '{}' was saved; annotations may be "
               "elsewhere\n",
               program.string(), options.file);
  }
  return read.session;
}

ui::ReportInput simulate_session(const ui::Session& session, Watch& watch) {
  const auto source = std::make_shared<const SourceText>(SourceText::from_file(session.program));
  SimulatedRuns made = simulate_all(session.reading, session.runs, session.load, source, watch);
  ui::ReportInput input = ui::report_input(session, made.shown);
  input.unmade = std::move(made.unmade);
  add_traces(input, session.traces, watch);
  return input;
}

}  // namespace feedscope
