#include "app/asked_program.h"

#include <fmt/format.h>

#include "app/number_option.h"
#include "core/base/error.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/session_runs.h"
#endif

namespace feedscope {

AskedProgram asked_program(const ProgramOptions& options, [[maybe_unused]] std::vector<GivenOption> more) {
  AskedProgram asked;
#ifdef FEEDSCOPE_WITH_UI
  if (const std::optional<ui::Session> session = asked_session(options, std::move(more))) {
    asked.file = session->program.string();
    asked.reading = session->reading;
    for (const ui::RunItem& run : session->runs) {
      asked.setups.push_back(run.setup.setup());
      asked.setups.back().load = session->load;
    }
    asked.current = session->current_run;
    asked.source = std::make_shared<const SourceText>(SourceText::from_file(session->program));
    return asked;
  }
#else
  if (names_session(options.file)) {
    throw InputError(
        fmt::format("'{}' is a session, which this build without the window cannot read; give the NC program",
                    options.file));
  }
#endif
  asked.file = options.file;
  asked.reading = options.reading();
  asked.source = std::make_shared<const SourceText>(SourceText::from_file(options.file));
  return asked;
}

void add_run_number_option(CLI::App& command, std::optional<std::size_t>& number) {
  add_number_option(
      command, "--run", whole_numbers(1, 1'000'000),
      [&number](double value) { number = static_cast<std::size_t>(value); },
      "Number of the run in a session [the current one]")
      ->type_name("N");
}

Setup asked_setup(const RunOptions& options, std::optional<std::size_t> number, const AskedProgram& asked) {
  if (!asked.is_session()) {
    if (number) {
      throw InputError(fmt::format("--run {} selects a run of a session, but '{}' is not a session", *number,
                                   options.file));
    }
    return make_setup(options.request(asked.dialect()));
  }
  const std::size_t chosen = number.value_or(asked.current + 1);
  if (chosen < 1 || chosen > asked.setups.size()) {
    throw InputError(fmt::format("--run {} is not a run of session '{}'; it has runs 1 to {}", chosen,
                                 options.file, asked.setups.size()));
  }
  if (!number && asked.setups.size() > 1) {
    fmt::print(stderr,
               "feedscope: note: session '{}' has {} runs; run {} is simulated; --run selects another one\n",
               options.file, asked.setups.size(), chosen);
  }
  return asked.setups[chosen - 1];
}

}  // namespace feedscope
