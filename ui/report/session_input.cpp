#include "ui/report/session_input.h"

namespace feedscope::ui {

ReportInput report_input(const Session& session,
                         const std::vector<std::shared_ptr<const ShownRun>>& results) {
  ReportInput input;
  const QStringList titles =
      results.empty() ? QStringList() : run_titles(session.runs, results.front()->run.input.feed_controls);
  for (std::size_t i = 0; i < session.runs.size(); ++i) {
    input.runs.push_back({results[i], titles[static_cast<qsizetype>(i)], session.runs[i].colour});
  }
  input.current = session.current_run;
  input.scene = session.scene;
  input.cursor = session.cursor;
  input.reference = session.scenes.reference ? session.scenes.reference : session.scenes.other;
  input.view.reset();
  input.charts = session.charts;
  input.annotations = session.annotations;
  input.identification = session.identification.result;
  return input;
}

}  // namespace feedscope::ui
