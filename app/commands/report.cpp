#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QTimeZone>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/language_option.h"
#include "app/display_units.h"
#include "app/number_option.h"
#include "app/option_text.h"
#include "app/output_file.h"
#include "app/output_format.h"
#include "app/picture_size.h"
#include "app/session_runs.h"
#include "app/trace_files.h"
#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "ui/page/page.h"
#include "ui/report/report.h"
#include "ui/report/template_pictures.h"
#include "ui/theme/offscreen_application.h"

namespace feedscope {
namespace {

struct ReportOptions {
  SeveralRunsOptions runs;
  TraceFiles traces;
  std::string out;
  std::string format;
  std::string page;  ///< template file
  std::string title;
  std::string author;
  std::string date;
  std::string camera;  ///< "": iso, or the session's
  std::string remarks;
  std::string logo;                  ///< picture file
  std::vector<std::string> without;  ///< placeholders
  std::vector<std::string> with;     ///< sections
  bool brief = false;
  std::string within;  ///< [mm], as typed
  std::string language;
  std::string paper = "A4";
  double dpi = 0;  ///< 0: not given
  bool progress = false;
};

constexpr double usual_dpi = 96;
constexpr double largest_dpi = 600;
const std::map<std::string, ui::Paper> papers{{"A4", ui::Paper()}, {"Letter", ui::letter_paper}};
const std::string pages_format = "png";
const std::string report_format = "feedpages";
const std::vector<std::string> report_formats{"pdf", "html", pages_format};

/// The output format. Throws InputError for options that conflict with it.
std::string format_of(const ReportOptions& options) {
  if (options.format.empty() && asks_for_pages(options.out)) {
    return report_format;
  }
  const std::string format = output_format(options.out, options.format, report_formats);
  if (format == pages_format && options.out == "-") {
    throw InputError("--format png writes a file for each page; give --out FILE.png instead of -");
  }
  if (format != pages_format && options.dpi != 0) {
    throw InputError(fmt::format("--dpi has no effect with {}; end --out in .png", format));
  }
  return format;
}

/// "slot-2.png" for the second page of "slot.png".
std::string file_of_page(const std::string& out, std::size_t page) {
  const std::filesystem::path path(out);
  return (path.parent_path() /
          fmt::format("{}-{}{}", path.stem().string(), page + 1, path.extension().string()))
      .string();
}

/// The placeholders to omit. Throws InputError for a name that is not a placeholder of reports.
QStringList left_out(const ReportOptions& options) {
  const QStringList known = ui::report_placeholders();
  QStringList names;
  for (const std::string& name : options.without) {
    if (!known.contains(QString::fromStdString(name))) {
      std::vector<std::string> all;
      for (const QString& one : known) {
        all.push_back(one.toStdString());
      }
      const std::string near = nearest_name(name, all);
      throw InputError(fmt::format("--without '{}' is not a part of reports; {}", name,
                                   near.empty() ? fmt::format("they are: {}", fmt::join(all, ", "))
                                                : fmt::format("did you mean '{}'?", near)));
    }
    names.append(QString::fromStdString(name));
  }
  return names;
}

/// The sections to include. Throws InputError for a section that `page` does not offer.
QStringList asked_sections(const ReportOptions& options, const ui::ReportTemplate& page) {
  QStringList names = options.brief ? QStringList() : ui::ReportInput().with;
  std::vector<std::string> all{"all"};
  for (const QString& one : page.sections()) {
    all.push_back(one.toStdString());
  }
  for (const std::string& name : options.with) {
    if (std::ranges::find(all, name) == all.end()) {
      const std::string near = nearest_name(name, all);
      throw InputError(fmt::format("--with '{}' is not a section of this report; {}", name,
                                   near.empty() ? fmt::format("they are: {}", fmt::join(all, ", "))
                                                : fmt::format("did you mean '{}'?", near)));
    }
    names.append(QString::fromStdString(name));
  }
  return names;
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
  whole += command_text(options.traces);
  add("--title", options.title);
  add("--author", options.author);
  add("--date", options.date);
  add("--camera", options.camera == "iso" ? "" : options.camera);
  add("--template", options.page);
  add("--remarks", options.remarks);
  add("--logo", options.logo);
  add("--without", fmt::format("{}", fmt::join(options.without, ",")));
  add("--with", fmt::format("{}", fmt::join(options.with, ",")));
  add("--within", options.within);
  add("--paper", options.paper == "A4" ? "" : options.paper);
  add("--display-units", asked_display_units());
  add("--language", options.language == usual_language() ? "" : options.language);
  add("--format", options.format);
  add("--dpi", options.dpi != 0 ? fmt::format("{}", options.dpi) : "");
  whole += options.brief ? " --brief" : "";
  add("--out", options.out);
  QStringList commands{QString::fromStdString(whole)};
  for (const AskedRun& run : runs) {
    commands.append(QString::fromStdString(
        fmt::format("feedscope simulate {} {}", program_text(options.runs), run.options)));
  }
  return commands;
}

int report(const ReportOptions& options) {
  const std::string format = format_of(options);
  const QStringList without = left_out(options);
  const QString logo =
      options.logo.empty() ? QString() : ui::inline_picture_url(QString::fromStdString(options.logo));
  const QDateTime date = date_of(options.date);
  const std::optional<double> within =
      options.within.empty() ? std::nullopt : std::optional(parse_length(options.within, "--within"));
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
  for (const std::string& trace : options.traces.files) {
    check_outputs(trace, {options.out}, "a trace");
  }
  if (session) {
    check_outputs(session->program.string(), {options.out});
  }
  const ui::ReportTemplate page = ui::load_report_template(QString::fromStdString(options.page));
  const QStringList with = asked_sections(options, page);
  OutputFiles files;
  std::ostream* const out = &files.add(format == pages_format ? file_of_page(options.out, 0) : options.out);
  ui::ReportInput input;
  if (options.progress) {
    Watch::tell_in_lines();
  }
  {
    Watch watch;
    input = session ? simulate_session(*session, watch)
                    : simulate_runs(options.runs.reading(), runs, source, watch);
    add_traces(input, options.traces, watch);
    input.title = QString::fromStdString(options.title);
    input.author = QString::fromStdString(options.author);
    input.date = date;
    if (!session || !options.camera.empty()) {
      input.view = camera_views.at(options.camera.empty() ? "iso" : options.camera);
    }
    input.commands = commands_of(options, runs);
    input.remarks = QString::fromStdString(options.remarks);
    input.logo = logo;
    input.without = without;
    input.with = with;
    input.within = within;
    input.paper = papers.at(options.paper);
    input.tolerances_asked = options.runs.tolerances.size();
    const ui::OffscreenApplication application;
    speak_in(options.language, input, session);
    Progress* const drawing = watch.stage("drawing");
    if (format == pages_format) {
      const std::vector<std::string> pages =
          ui::make_report_pictures(input, page, options.dpi != 0 ? options.dpi : usual_dpi, drawing);
      for (std::size_t i = 0; i < pages.size(); ++i) {
        (i == 0 ? *out : files.add(file_of_page(options.out, i))) << pages[i];
      }
    } else {
      *out << (format == "html"
                   ? ui::make_page(input, page, drawing)
                   : ui::make_report(input, page,
                                     format == "pdf" ? ui::ReportFormat::pdf : ui::ReportFormat::pages,
                                     drawing));
    }
  }
  files.commit();
  return tell_of_shown_runs(input, options.runs.tolerances);
}

}  // namespace

Command add_report_command(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "Write a report of one or more runs of a program; needs no display");
  add_several_runs_options(*command, options->runs);
  add_trace_files(*command, options->traces);
  command->add_option("--out", options->out, "The report to write; - for standard output")
      ->type_name("FILE.pdf|FILE.html|FILE.png")
      ->required();
  add_display_units_option(*command);
  command
      ->add_option("--format", options->format,
                   "pdf, html, or png: a picture of each page, FILE-1.png, FILE-2.png ... [the ending of "
                   "--out]")
      ->check(CLI::IsMember(report_formats))
      ->type_name("FORMAT");
  command
      ->add_option("--template", options->page, "HTML template of your own; see resources/report/README.md")
      ->type_name("FILE.html");
  command->add_option("--title", options->title, "Title [the program's name]")->type_name("TEXT");
  command->add_option("--author", options->author, "Author of the report")->type_name("TEXT");
  command
      ->add_option("--remarks", options->remarks,
                   "Words of your own below the title; an empty line begins a paragraph")
      ->type_name("TEXT");
  command->add_option("--logo", options->logo, "Picture above the title: PNG, JPEG or SVG")
      ->type_name("FILE");
  command
      ->add_option("--without", options->without,
                   "Parts to omit, by their names in resources/report/README.md: time_changes,charts")
      ->delimiter(',')
      ->type_name("NAME,...");
  command
      ->add_option(
          "--with", options->with,
          "Sections to add after the four pages, or all: time,causes,charts,contour,machine,settings")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_flag("--brief", options->brief, "Two pages: the decision and the places that lose most");
  command
      ->add_option("--within", options->within, "Maximum contour error in mm of the run that is recommended")
      ->type_name("MM");
  command->add_option("--paper", options->paper, "Sheet of the pages: A4, Letter")
      ->check(CLI::IsMember(papers))
      ->type_name("PAPER")
      ->capture_default_str();
  add_language_option(*command, options->language);
  add_number_option(
      *command, "--dpi", numbers(36, largest_dpi), [options](double dpi) { options->dpi = dpi; },
      "Pixels an inch of pages as pictures [96]")
      ->type_name("N");
  command->add_flag("--progress", options->progress,
                    "Tell the progress on standard error in lines, for programs that run this one");
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
