#include <fmt/format.h>

#include <QTimeZone>

#include <map>
#include <memory>
#include <string>

#include "app/commands/command.h"
#include "app/display_units.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/output_format.h"
#include "app/picture_size.h"
#include "app/print.h"
#include "app/session_runs.h"
#include "core/base/error.h"
#include "ui/report/report.h"
#include "ui/theme/offscreen_application.h"

namespace feedscope {
namespace {

struct ReportOptions {
  SeveralRunsOptions runs;
  std::string out;
  std::string format;
  std::string page;  ///< template file
  std::string title;
  std::string author;
  std::string date;
  std::string camera;  ///< "": iso, or the session's
};

const std::map<std::string, ui::ReportFormat> report_formats{{"pdf", ui::ReportFormat::pdf},
                                                             {"html", ui::ReportFormat::html}};

ui::ReportFormat format_of(const ReportOptions& options) {
  return report_formats.at(output_format(options.out, options.format, {"pdf", "html"}));
}

QDateTime date_of(const std::string& text) {
  if (text.empty()) {
    return {};
  }
  const QDate date = QDate::fromString(QString::fromStdString(text), Qt::ISODate);
  if (!date.isValid()) {
    throw InputError(
        fmt::format("--date '{}' is not a date; give year, month and day, such as 2025-01-31", text));
  }
  return {date, QTime(0, 0), QTimeZone::utc()};
}

/// The command of the report, then one for each run alone.
QStringList commands_of(const ReportOptions& options, const std::vector<AskedRun>& runs) {
  std::string whole = "feedscope report " + options_text(options.runs);
  const auto add = [&](const char* name, const std::string& value) {
    whole += value.empty() ? "" : fmt::format(" {} {}", name, in_quotes(value));
  };
  add("--title", options.title);
  add("--author", options.author);
  add("--date", options.date);
  add("--camera", options.camera == "iso" ? "" : options.camera);
  add("--template", options.page);
  add("--format", options.format);
  add("--out", options.out);
  QStringList commands{QString::fromStdString(whole)};
  for (const AskedRun& run : runs) {
    commands.append(QString::fromStdString(
        fmt::format("feedscope simulate {} {}", program_text(options.runs), run.options)));
  }
  return commands;
}

int report(const ReportOptions& options) {
  const ui::ReportFormat format = format_of(options);
  const QDateTime date = date_of(options.date);
  std::optional<ui::Session> session = asked_session(options.runs);
  if (session) {
    session->load = asked_load(options.runs.load, std::move(session->load));
  }
  const auto source =
      session ? nullptr : std::make_shared<const SourceText>(SourceText::from_file(options.runs.file));
  const std::vector<AskedRun> runs =
      session ? std::vector<AskedRun>() : asked_runs(options.runs, dialect_of(options.runs, *source));
  check_outputs(options.runs.file, {options.out});
  check_outputs(options.runs.load, {options.out}, "the load file");
  if (session) {
    check_outputs(session->program.string(), {options.out});
  }
  const ui::ReportTemplate page = ui::load_report_template(QString::fromStdString(options.page));
  OutputFile out(options.out);
  ui::ReportInput input;
  {
    Watch watch;
    input = session ? simulate_session(*session, watch)
                    : simulate_runs(options.runs.reading(), runs, source, watch);
    input.title = QString::fromStdString(options.title);
    input.author = QString::fromStdString(options.author);
    input.date = date;
    if (!session || !options.camera.empty()) {
      input.view = camera_views.at(options.camera.empty() ? "iso" : options.camera);
    }
    input.commands = commands_of(options, runs);
    const ui::OffscreenApplication application;
    out.stream() << ui::make_report(input, page, format, watch.stage("drawing"));
  }
  out.commit();
  if (!options.runs.tolerances.empty()) {
    note_replaced_tolerance(*input.program().toolpath);
  }
  note_shown_runs(input);
  const Program& program = *input.program().program;
  print_diagnostics(program);
  return has_errors(program.diagnostics) ? exit_code::program_errors : exit_code::done;
}

}  // namespace

Command add_report_command(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "Write a report of one or more runs of a program; needs no display");
  add_several_runs_options(*command, options->runs);
  command->add_option("--out", options->out, "The report to write; - for standard output")
      ->type_name("FILE.pdf|FILE.html")
      ->required();
  add_display_units_option(*command);
  command->add_option("--format", options->format, "pdf or html [the ending of --out]")
      ->check(CLI::IsMember(report_formats))
      ->type_name("FORMAT");
  command
      ->add_option("--template", options->page, "HTML template of your own; see resources/report/README.md")
      ->type_name("FILE.html");
  command->add_option("--title", options->title, "Title [the program's name]")->type_name("TEXT");
  command->add_option("--author", options->author, "Author of the report")->type_name("TEXT");
  command->add_option("--date", options->date, "Date of the report [none, so that it can be reproduced]")
      ->type_name("YYYY-MM-DD");
  command
      ->add_option("--camera", options->camera,
                   "View direction: iso, top, front, right [iso, or the session's]")
      ->check(CLI::IsMember(camera_views))
      ->type_name("CAMERA");
  return {command, [options] {
            move_tolerance(options->runs.set, options->runs.tolerances);
            return report(*options);
          }};
}

}  // namespace feedscope
