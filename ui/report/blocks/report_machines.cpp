#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/base/geometry.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/workbench/setup_state.h"
#include "ui/workbench/tolerance_text.h"

namespace feedscope::ui {

namespace {

/// Digits of numbers in the unit of their key, and of converted ones.
int digits_of(const KeyUnit& unit) {
  return unit.factor == 1 ? 8 : 5;
}

QString value_text(const SettingValue& value, const KeyUnit& unit) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? significant_number(*number * unit.factor, digits_of(unit))
                           : html_text(core_text(std::get<std::string>(value)));
}

/// "X, Y: Essid 2019, table 2"; in italics if assumed.
QString source_text(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  if (found == machine.provenance.end()) {
    return {};
  }
  const QString source = html_text(found->second.source);
  return found->second.assumed ? QStringLiteral("<i>%1</i>").arg(ReportWords::tr("assumed: %1").arg(source))
                               : source;
}

bool assumed(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  return found != machine.provenance.end() && found->second.assumed;
}

/// Sources of a limit, grouped by axes with equal sources.
QString axis_sources(const Machine& machine, const std::string& limit) {
  std::vector<std::pair<QString, QString>> sources;  // axes, source
  for (const auto& [axis, kind] : machine.axes.axes()) {
    const QString source = source_text(machine, axis_key(axis, limit));
    const auto same = std::ranges::find(sources, source, &std::pair<QString, QString>::second);
    if (same != sources.end()) {
      same->first += QStringLiteral(" %1").arg(QChar(axis));
    } else {
      sources.emplace_back(QString(QChar(axis)), source);
    }
  }
  if (sources.size() == 1) {
    return sources.front().second;
  }
  QStringList lines;
  for (const auto& [axes, source] : sources) {
    lines.append(ReportWords::tr("%1: %2").arg(axes, source));
  }
  return lines.join(QStringLiteral("<br/>"));
}

/// "–" if the drive of an axis has no such value.
QString axis_value_text(const Machine& machine, char axis, const std::string& key, const KeyUnit& unit) {
  const SettingValue value = axis_value(machine, axis, key);
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? significant_number(*number * unit.factor, digits_of(unit)) : QStringLiteral("–");
}

bool has_any(const Machine& machine, const std::string& key) {
  return std::ranges::any_of(machine.axes.axes(), [&](const AxisInfo& axis) {
    return axis_value(machine, axis.name, key) != SettingValue(std::string());
  });
}

/// Limits and travel of the rotary axes, then the chain; empty without rotary axes.
QString rotary_table(const Machine& machine) {
  if (machine.kinematics.empty()) {
    return QString();
  }
  HtmlTable table("lrll", {24, 12, 10, 54});
  table.add_head({ReportWords::tr("Rotary axis"), ReportWords::tr("Value"), ReportWords::tr("Unit"),
                  ReportWords::tr("Source")});
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    for (const SettingSpec& spec : rotary_axis_specs()) {
      const SettingValue value = axis_value(machine, axis.name, spec.key);
      if (const double* number = std::get_if<double>(&value)) {
        table.add({ReportWords::tr("%1 of %2", "of an axis")
                       .arg(html_text(core_text(spec.title)), QString(QChar(axis.name))),
                   significant_number(*number, 6), html_text(spec.unit),
                   source_text(machine, axis_key(axis.name, spec.key))});
      }
    }
  }
  table.add({ReportWords::tr("Chain, part to tool"), html_text(machine.kinematics.chain), QString(),
             source_text(machine, "kinematics.chain")});
  return table.html();
}

QString axis_table(const Machine& machine) {
  const AxisList& axes = machine.axes.axes();
  constexpr int for_a_number = 9;  // [%] of the width
  std::string sides = "l";
  std::vector<int> widths{18};
  QStringList head{ReportWords::tr("Limit")};
  for (const AxisInfo& axis : axes) {
    sides += 'r';
    widths.push_back(for_a_number);
    head << QString(QChar(axis.name));
  }
  widths.insert(widths.end(), {for_a_number, 100 - 18 - for_a_number * (static_cast<int>(axes.size()) + 1)});
  HtmlTable table(sides + "ll", widths);
  table.add_head(head << ReportWords::tr("Unit") << ReportWords::tr("Source"));
  for (const SettingSpec& spec : axis_specs()) {
    if (!has_any(machine, spec.key)) {
      continue;
    }
    const KeyUnit unit = key_unit(spec.unit);
    QStringList cells{html_text(core_text(spec.title))};
    for (const auto& [axis, kind] : axes) {
      const QString value = axis_value_text(machine, axis, spec.key, unit);
      cells.append(assumed(machine, axis_key(axis, spec.key)) ? QStringLiteral("<i>%1</i>").arg(value)
                                                              : value);
    }
    cells.append(unit.text);
    cells.append(axis_sources(machine, spec.key));
    table.add(cells);
  }
  return table.html();
}

std::map<std::string, SettingSpec> specs_of_all_settings() {
  std::map<std::string, SettingSpec> specs;
  for (const SettingSpec& spec : common_settings()) {
    specs.emplace(spec.key, spec);
  }
  for (const SettingSpec& spec : all_model_settings()) {
    specs.emplace(spec.key, spec);
  }
  return specs;
}

QString setting_title(const std::map<std::string, SettingSpec>& specs, const std::string& key) {
  const auto found = specs.find(key);
  return found == specs.end() ? html_text(key) : html_text(core_text(found->second.title));
}

KeyUnit setting_unit(const std::map<std::string, SettingSpec>& specs, const std::string& key) {
  const auto found = specs.find(key);
  return found == specs.end() ? KeyUnit() : key_unit(found->second.unit);
}

QString control_table(const Machine& machine) {
  const std::map<std::string, SettingSpec> specs = specs_of_all_settings();
  HtmlTable table("lrll", {31, 14, 9, 46});
  table.add_head({ReportWords::tr("Control"), ReportWords::tr("Value"), ReportWords::tr("Unit"),
                  ReportWords::tr("Source")});
  for (const auto& [key, value] : machine.settings.values()) {
    const KeyUnit unit = setting_unit(specs, key);
    const QString text = value_text(value, unit);
    table.add({setting_title(specs, key),
               assumed(machine, key) ? QStringLiteral("<i>%1</i>").arg(text) : text, unit.text,
               source_text(machine, key)});
  }
  return table.empty() ? QString() : table.html();
}

/// A user setting as a row of a table: its name and a value for each run, "" where it does not apply.
struct SettingRow {
  QString title;
  QString unit;
  std::vector<QString> values;
  bool differs() const { return std::ranges::adjacent_find(values, std::not_equal_to()) != values.end(); }
};

SettingRow row_of(const ReportInput& input, const QString& title, const QString& unit, const auto& value) {
  SettingRow row{title, unit, {}};
  for (const ReportRun& run : input.runs) {
    row.values.push_back(value(run.shown->run.setup));
  }
  return row;
}

std::vector<SettingRow> identity_rows(const ReportInput& input) {
  return {row_of(input, ReportWords::tr("Machine"), {},
                 [](const Setup& setup) { return html_text(setup.machine.name); }),
          row_of(input, ReportWords::tr("Model"), {},
                 [](const Setup& setup) { return html_text(setup.model->info().id); })};
}

/// The tolerances in force, which the program may set.
SettingRow tolerance_row(const ReportInput& input) {
  SettingRow row{ReportWords::tr("Tolerance in force"), unit_of(Dimension::length), {}};
  for (const ReportRun& run : input.runs) {
    row.values.push_back(
        tolerance_range(tolerance_in_force(run.shown->run.input.feed_controls, run.shown->run.setup)));
  }
  return row;
}

std::vector<SettingRow> limit_rows(const ReportInput& input) {
  std::vector<SettingRow> rows;
  for (const SettingSpec& spec : axis_specs()) {
    const KeyUnit unit = key_unit(spec.unit);
    for (const auto& [axis, kind] : known_axes) {
      rows.push_back(row_of(input,
                            ReportWords::tr("%1 of %2", "of an axis")
                                .arg(html_text(core_text(spec.title)), QString(QChar(axis))),
                            unit.text, [&spec, &unit, axis = axis](const Setup& setup) {
                              return axis_value_text(setup.machine, axis, spec.key, unit);
                            }));
    }
  }
  return rows;
}

std::vector<SettingRow> setting_rows(const ReportInput& input) {
  const std::map<std::string, SettingSpec> specs = specs_of_all_settings();
  std::set<std::string> keys;
  for (const ReportRun& run : input.runs) {
    for (const auto& [key, value] : run.shown->run.setup.settings.values()) {
      keys.insert(key);
    }
  }
  std::vector<SettingRow> rows;
  for (const std::string& key : keys) {
    const KeyUnit unit = setting_unit(specs, key);
    rows.push_back(row_of(input, setting_title(specs, key), unit.text, [&](const Setup& setup) {
      const auto found = setup.settings.values().find(key);
      return found == setup.settings.values().end() ? QStringLiteral("–") : value_text(found->second, unit);
    }));
  }
  return rows;
}

/// One column for each run, in as many tables as needed.
QString rows_table(const ReportInput& input, const std::vector<SettingRow>& rows, bool mark_differing) {
  QString html;
  const std::size_t count = input.runs.size();
  for (std::size_t first = 0; first < count && !rows.empty(); first += runs_a_table) {
    const std::size_t end = std::min(count, first + runs_a_table);
    const int share = static_cast<int>(60 / (end - first));
    std::vector<int> widths{30, 10};
    widths.resize(2 + end - first, share);
    HtmlTable table("ll" + std::string(end - first, 'r'), widths);
    QStringList head{ReportWords::tr("Setting"), ReportWords::tr("Unit")};
    for (std::size_t i = first; i < end; ++i) {
      head.append(run_label(input, i));
    }
    table.add_head(head);
    for (const SettingRow& row : rows) {
      QStringList cells{row.title, row.unit};
      for (std::size_t i = first; i < end; ++i) {
        const bool marked = mark_differing && row.differs();
        cells.append(marked ? QStringLiteral("<b>%1</b>").arg(row.values[i]) : row.values[i]);
      }
      table.add(cells);
    }
    html += table.html();
  }
  return html;
}

}  // namespace

QString machines_block(const ReportInput& input) {
  QString html;
  std::vector<const Machine*> done;
  for (const ReportRun& run : input.runs) {
    const Machine& machine = run.shown->run.setup.machine;
    if (std::ranges::any_of(done, [&](const Machine* other) { return *other == machine; })) {
      continue;
    }
    done.push_back(&machine);
    const QString control =
        machine.control.empty() ? QString() : QStringLiteral(", %1").arg(html_text(machine.control));
    html += QStringLiteral("<h3>%1%2</h3>\n<p class=\"small\">%3</p>\n")
                .arg(html_text(machine.name), control, html_text(machine.reference));
    html += axis_table(machine);
    html += rotary_table(machine);
    html += QStringLiteral("<p class=\"gap\"></p>\n") + control_table(machine);
  }
  return html;
}

QString differing_settings_block(const ReportInput& input) {
  std::vector<SettingRow> rows;
  for (std::vector<SettingRow> (*part)(const ReportInput&) : {identity_rows, limit_rows, setting_rows}) {
    for (SettingRow& row : part(input)) {
      if (row.differs()) {
        rows.push_back(std::move(row));
      }
    }
  }
  return rows_table(input, rows, false);
}

QString settings_block(const ReportInput& input) {
  std::vector<SettingRow> rows = identity_rows(input);
  rows.push_back(tolerance_row(input));
  std::ranges::move(setting_rows(input), std::back_inserter(rows));
  return rows_table(input, rows, true);
}

}  // namespace feedscope::ui
