#include "ui/report/blocks/report_trust.h"

#include <QLocale>
#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/analysis/run/program_facts.h"
#include "ui/language/core_texts.h"
#include "ui/language/in_language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/setting_texts.h"

namespace feedscope::ui {

namespace {

QString trust_heading(const QString& text) {
  return QStringLiteral("<h3>%1</h3>\n").arg(text);
}

QString trust_line(const QString& html) {
  return QStringLiteral("<p class=\"fine\">%1</p>\n").arg(html);
}

/// A publication, in its own language.
QString source_span(const std::string& reference) {
  return QStringLiteral("<span class=\"source\">%1</span>").arg(html_text(reference));
}

/// A machine as the runs have it: their limits may differ.
using MachineOfRuns = std::vector<const Machine*>;

std::vector<MachineOfRuns> machines_of(const ReportInput& input) {
  std::vector<MachineOfRuns> machines;
  for (const ReportRun& run : input.runs) {
    const Machine& machine = run.shown->run.setup.machine;
    const auto same = std::ranges::find_if(
        machines, [&](const MachineOfRuns& other) { return other.front()->id == machine.id; });
    (same == machines.end() ? machines.emplace_back() : *same).push_back(&machine);
  }
  return machines;
}

QString limit_text(const Machine& machine, char axis, const SettingSpec& spec) {
  const SettingValue value = axis_value(machine, axis, spec.key);
  const double* number = std::get_if<double>(&value);
  if (number == nullptr) {
    return QStringLiteral("–");
  }
  const QString text = significant_number(*number * key_unit(spec.unit).factor, 5);
  const auto source = machine.provenance.find(axis_key(axis, spec.key));
  return source != machine.provenance.end() && source->second.assumed ? QStringLiteral("<i>%1</i>").arg(text)
                                                                      : text;
}

/// "20", or "20 / 10" where the runs have two values.
QString limit_texts(const MachineOfRuns& machine, char axis, const SettingSpec& spec) {
  QStringList texts;
  for (const Machine* one : machine) {
    texts.append(limit_text(*one, axis, spec));
  }
  texts.removeDuplicates();
  return texts.join(QStringLiteral(" / "));
}

/// Velocity, acceleration and jerk of some axes, with the specs of these limits for such axes.
QString limits_table(const MachineOfRuns& machine, const QString& title, std::span<const SettingSpec> specs,
                     const std::vector<char>& axes) {
  constexpr std::size_t limits = 3;
  HtmlTable table("lrrr", {16, 28, 28, 28});
  QStringList head{title};
  for (const SettingSpec& spec : specs.first(limits)) {
    head.append(
        QStringLiteral("%1<br/>[%2]").arg(html_text(core_text(spec.title)), key_unit(spec.unit).text));
  }
  table.add_head(head);
  for (const char axis : axes) {
    QStringList cells{QString(QChar(axis))};
    for (const SettingSpec& spec : specs.first(limits)) {
      cells.append(limit_texts(machine, axis, spec));
    }
    table.add(cells);
  }
  return axes.empty() ? QString() : table.html();
}

QString limits_tables(const MachineOfRuns& machine) {
  std::vector<char> linear;
  for (const AxisInfo& axis : machine.front()->axes.axes()) {
    linear.push_back(axis.name);
  }
  std::vector<char> rotary;
  for (const RotaryAxis& axis : machine.front()->kinematics.rotary) {
    rotary.push_back(axis.name);
  }
  return limits_table(machine, ReportWords::tr("Axis"), axis_limit_specs(), linear) +
         limits_table(machine, ReportWords::tr("Rotary axis"), rotary_axis_specs(), rotary);
}

QString machine_part(const MachineOfRuns& of_runs) {
  const Machine& machine = *of_runs.front();
  const QString control =
      machine.control.empty() ? QString() : QStringLiteral(", %1").arg(html_text(machine.control));
  return trust_heading(ReportWords::tr("Machine")) +
         trust_line(QStringLiteral("<b>%1</b>%2").arg(html_text(machine.name), control)) +
         limits_tables(of_runs) +
         trust_line(ReportWords::tr("Values in italics are assumed. Source: %1")
                        .arg(source_span(machine.reference)));
}

/// "Contour tolerance 0.02 mm": what of a setup is not that of the machine's file.
QStringList changed_settings(const Setup& setup) {
  const Settings usual = complete_settings(*setup.model, setup.machine);
  std::map<std::string, SettingValue> changed;
  for (const auto& [key, value] : setup.settings.values()) {
    if (!usual.has(key) || usual.value(key) != value) {
      changed[key] = value;
    }
  }
  return setting_texts(changed);
}

QString settings_part(const ReportInput& input) {
  QString html = trust_heading(ReportWords::tr("Settings that differ from the machine's file"));
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    const QStringList changed = changed_settings(input.runs[i].shown->run.setup);
    const QString text =
        changed.isEmpty() ? ReportWords::tr("none") : html_text(changed.join(QStringLiteral("; ")));
    html +=
        trust_line(input.runs.size() > 1 ? QStringLiteral("<b>%1</b> %2").arg(run_letter(i), text) : text);
  }
  return html;
}

QString first_sentence(const QString& text) {
  const qsizetype end = text.indexOf(QStringLiteral(". "));
  return end < 0 ? text : text.left(end + 1);
}

QString models_part(const ReportInput& input) {
  QString html = trust_heading(ReportWords::tr("Control models"));
  std::set<std::string> done;
  for (const ReportRun& run : input.runs) {
    const ModelInfo& info = run.shown->run.setup.model->info();
    if (done.insert(info.id).second) {
      const QString reference =
          info.reference.empty() ? QString() : QStringLiteral(" (%1)").arg(source_span(info.reference));
      html += trust_line(
          QStringLiteral("<b>%1</b> %2%3")
              .arg(html_text(info.id), html_text(first_sentence(core_text(info.summary))), reference));
    }
  }
  return html;
}

QString program_part(const ReportInput& input) {
  const Program& program = *input.program().program;
  const ProgramFacts facts = facts_of(program, *input.runs.front().shown->run.path);
  return trust_heading(ReportWords::tr("Program")) +
         trust_line(ReportWords::tr("%1: %2, %3 lines, path of %4 %5, %6 of it rapid.")
                        .arg(html_text(program_file_name(program)),
                             html_text(core_text(std::string(info_of(program.dialect).title))),
                             QLocale().toString(static_cast<qulonglong>(facts.lines)),
                             fixed(facts.path_length, Dimension::length), unit_of(Dimension::length),
                             fixed(facts.rapid_length, Dimension::length)));
}

QString trust_part(const ReportInput& input) {
  const bool drives = std::ranges::any_of(
      input.runs, [](const ReportRun& run) { return summary_of(run).actual.has_value(); });
  return trust_heading(ReportWords::tr("How far to trust it")) +
         trust_line(
             ReportWords::tr("All numbers are simulated, not measured: compare one cycle time with the "
                             "machine before relying on them.")) +
         trust_line(
             drives ? ReportWords::tr("Not modelled: cutting forces on the axes, vibration, friction beyond "
                                      "that of the drives that are set, temperature, spindle.")
                    : ReportWords::tr("Not modelled: the drives (the axes follow exactly), cutting forces on "
                                      "the axes, vibration, temperature, spindle.")) +
         remarks_html(input);
}

}  // namespace

QString trust_block(const ReportInput& input) {
  QString left;
  for (const MachineOfRuns& machine : machines_of(input)) {
    left += machine_part(machine);
  }
  left += settings_part(input);
  const QString right = models_part(input) + program_part(input) + trust_part(input);
  return QStringLiteral(
             "<table class=\"columns fine\" width=\"100%\" cellspacing=\"0\" cellpadding=\"0\"><tr>"
             "<td width=\"48%\">%1</td><td width=\"4%\"></td><td width=\"48%\">%2</td></tr></table>\n")
      .arg(left, right);
}

}  // namespace feedscope::ui
