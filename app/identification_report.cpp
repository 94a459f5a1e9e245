#include "app/identification_report.h"

#include <filesystem>

#include "app/commands/language_option.h"
#include "app/output_format.h"
#include "core/base/error.h"
#include "ui/report/report.h"
#include "ui/shared/paths.h"
#include "ui/theme/offscreen_application.h"

namespace feedscope {
namespace {

const std::vector<std::string> formats{"pdf", "html"};

QString name_of(const ReportedRecording& recording) {
  return ui::to_qstring(std::filesystem::path(recording.file).filename());
}

ui::UsedRecording used(const ReportedRecording& recording) {
  return recording.trace != nullptr
             ? ui::used_recording(*recording.trace)
             : ui::used_recording(ui::SectionTable{QString::fromStdString(recording.file), recording.times});
}

std::shared_ptr<const ui::IdentificationOutcome> outcome_of(const IdentificationReport& made) {
  auto outcome = std::make_shared<ui::IdentificationOutcome>();
  outcome->date = date_of_today();
  outcome->program = ui::program_mark(made.models.front().runs.front().input);
  for (const ReportedRecording& recording : made.recordings) {
    outcome->recordings.push_back(used(recording));
  }
  outcome->models = made.models;
  outcome->unfitted = made.unfitted;
  return outcome;
}

}  // namespace

void check_report_name(const std::string& file) {
  output_format(file, "", formats);
}

std::string identification_report(const IdentificationReport& made, const std::string& file, Watch& watch) {
  const Identification& found = made.models.front();
  Run run = found.runs.front();
  run.setup.machine =
      made.machine_file.empty() ? found.setup.machine : identified_machine(found, made.machine_file);
  ui::ReportInput input;
  input.runs = ui::report_runs({ui::make_shown(std::move(run))});
  for (const ReportedRecording& recording : made.recordings) {
    if (recording.trace != nullptr && recording.of_first_program) {
      auto shown =
          ui::lay_beside(recording.trace, input.run().shown, watch.stage("comparing with the trace"));
      input.traces.push_back({std::move(shown), name_of(recording), ui::trace_colour(input.traces.size())});
    }
  }
  input.identification.outcome = outcome_of(made);
  input.commands = {QString::fromStdString(made.command)};
  input.without = {QStringLiteral("time_changes")};  // they are of the program, and take long
  const ui::OffscreenApplication application;
  speak_in(made.language, input, std::nullopt);
  const bool is_pdf = output_format(file, "", formats) == "pdf";
  return ui::make_report(input, ui::load_report_template(),
                         is_pdf ? ui::ReportFormat::pdf : ui::ReportFormat::html, watch.stage("drawing"));
}

}  // namespace feedscope
