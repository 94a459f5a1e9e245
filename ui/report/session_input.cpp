#include "ui/report/session_input.h"

namespace feedscope::ui {

ReportInput report_input(const Session& session,
                         const std::vector<std::shared_ptr<const ShownRun>>& results) {
  ReportInput input;
  for (std::size_t i = 0; i < session.runs.size(); ++i) {
    input.runs.push_back({results[i], run_title(session.runs[i], results[i]->run.input.feed_controls),
                          session.runs[i].colour});
  }
  input.current = session.current_run;
  input.scene = session.scene;
  input.reference = session.scenes.reference ? session.scenes.reference : session.scenes.other;
  input.view.reset();
  input.charts = session.charts;
  input.annotations = session.annotations;
  return input;
}

}  // namespace feedscope::ui
