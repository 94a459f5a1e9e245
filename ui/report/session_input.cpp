#include "ui/report/session_input.h"

#include <algorithm>
#include <optional>

namespace feedscope::ui {

ReportInput report_input(const Session& session,
                         const std::vector<std::shared_ptr<const ShownRun>>& results) {
  ReportInput input;
  const auto made = std::ranges::find_if(results, [](const auto& result) { return result != nullptr; });
  const QStringList titles =
      made == results.end() ? QStringList() : run_titles(session.runs, (*made)->run.input.feed_controls);
  std::vector<std::optional<std::size_t>> rows;  // in the input, for the runs of the session
  for (std::size_t i = 0; i < session.runs.size(); ++i) {
    rows.push_back(results[i] ? std::optional(input.runs.size()) : std::nullopt);
    if (results[i]) {
      input.runs.push_back({results[i], titles[static_cast<qsizetype>(i)], session.runs[i].colour});
    }
  }
  const auto row_of = [&](const std::optional<std::size_t>& run) {
    return run && *run < rows.size() ? rows[*run] : std::nullopt;
  };
  input.current = row_of(session.current_run).value_or(0);
  input.scene = session.scene;
  input.cursor = session.cursor;
  input.reference = row_of(session.scenes.reference ? session.scenes.reference : session.scenes.other);
  if (session.scene.camera != CameraState()) {  // else the session has no camera
    input.view.reset();
  }
  input.charts = session.charts;
  input.annotations = session.annotations;
  input.identification = session.identification.result;
  return input;
}

}  // namespace feedscope::ui
