#include "app/asked_program.h"

#ifdef FEEDSCOPE_WITH_UI
#include "app/session_runs.h"
#else
#include <fmt/format.h>

#include "core/base/error.h"
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
  if (options.file.ends_with(".feedscope")) {
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

}  // namespace feedscope
