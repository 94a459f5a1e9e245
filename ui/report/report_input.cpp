#include "ui/report/report_input.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/analysis/study/recommendation.h"
#include "core/machine/contour_tolerance.h"
#include "core/machine/machine.h"
#include "ui/workbench/run_list.h"
#include "ui/workbench/setting_texts.h"
#include "ui/workbench/tolerance_text.h"

namespace feedscope::ui {

namespace {

/// Keys of settings that do not have the same value in all runs of their model on their machine.
std::set<std::string> differing_settings(const std::vector<std::shared_ptr<const ShownRun>>& runs) {
  std::set<std::string> keys;
  for (const auto& a : runs) {
    for (const auto& b : runs) {
      const Setup& one = a->run.setup;
      const Setup& other = b->run.setup;
      for (const auto& [key, value] : one.settings.values()) {
        const auto found = other.settings.values().find(key);
        if (one.model == other.model && one.machine.id == other.machine.id &&
            found != other.settings.values().end() && found->second != value) {
          keys.insert(key);
        }
      }
    }
  }
  return keys;
}

using AxisLimit = std::pair<std::string, char>;

/// Limits of axes whose values differ among the runs on their machine.
std::set<AxisLimit> differing_limits(const std::vector<std::shared_ptr<const ShownRun>>& runs) {
  std::set<AxisLimit> limits;
  std::map<std::string, const Machine*> first;
  for (const auto& run : runs) {
    const Machine& machine = run->run.setup.machine;
    const Machine& other = *first.try_emplace(machine.id, &machine).first->second;
    for (const char axis : axis_names(machine)) {
      for (const SettingSpec& spec : axis_specs_of(axis)) {
        if (axis_value(machine, axis, spec.key) != axis_value(other, axis, spec.key)) {
          limits.emplace(spec.key, axis);
        }
      }
    }
  }
  return limits;
}

/// Machine, model, tolerance in force, settings and limits that differ.
QString name_of(const Run& run, bool with_machine, const std::set<std::string>& keys,
                const std::set<AxisLimit>& limits) {
  const Setup& setup = run.setup;
  QStringList parts;
  if (with_machine) {
    parts.append(QString::fromStdString(setup.machine.id));
  }
  parts.append(QString::fromStdString(setup.model->info().id));
  if (const auto tolerance = tolerance_in_force(run.input.feed_controls, setup)) {
    parts.append(tolerance_text(*tolerance));
  }
  std::map<std::string, SettingValue> values;
  for (const std::string& key : keys) {
    const bool said = key == contour_tolerance_key || key == program_tolerance_key;
    if (!said && setup.settings.has(key)) {
      values[key] = setup.settings.values().at(key);
    }
  }
  for (const auto& [limit, axis] : limits) {
    values[axis_key(axis, limit)] = axis_value(setup.machine, axis, limit);
  }
  return (parts + setting_texts(values)).join(QStringLiteral(", "));
}

}  // namespace

QString program_file_name(const Program& program) {
  return QString::fromStdString(program.source->name()).section('/', -1);
}

QString ReportInput::heading() const {
  return title.isEmpty() ? program_file_name(*program().program) : title;
}

namespace {

const QString name_joint = QStringLiteral(", ");

/// Parts common to all names.
QStringList common_parts(const ReportInput& input) {
  QStringList parts = input.runs.front().name.split(name_joint);
  parts.removeIf([&](const QString& part) {
    return !std::ranges::all_of(
        input.runs, [&](const ReportRun& run) { return run.name.split(name_joint).contains(part); });
  });
  return parts;
}

}  // namespace

QStringList short_names(const ReportInput& input) {
  const QStringList common = input.runs.size() > 1 ? common_parts(input) : QStringList();
  QStringList names;
  for (const ReportRun& run : input.runs) {
    QStringList own = run.name.split(name_joint);
    own.removeIf([&](const QString& part) { return common.contains(part); });
    names.append(own.isEmpty() ? run.name : own.join(name_joint));
  }
  return names;
}

QString lettered_title(const ReportInput& input, std::size_t run) {
  const QString name = short_names(input)[static_cast<qsizetype>(run)];
  return input.runs.size() > 1 ? run_letter(run) + ' ' + name : name;
}

QString common_name(const ReportInput& input) {
  return common_parts(input).join(name_joint);
}

std::vector<ComparedRun> run_figures(const ReportInput& input) {
  std::vector<ComparedRun> runs;
  for (const ReportRun& run : input.runs) {
    runs.push_back(figures_of(run.shown->run));
  }
  return runs;
}

ReportInput with_recommended_run(ReportInput input) {
  const bool of_current =
      !input.traces.empty() || input.identification.outcome != nullptr || input.charts.time;
  const auto leading = of_current ? std::nullopt : leading_run(run_figures(input), input.within);
  input.current = leading.value_or(input.current);
  return input;
}

ReportInput with_contour_reports(ReportInput input, Progress* progress) {
  constexpr std::size_t places = 100;  // similar ones are grouped
  for (ReportRun& run : input.runs) {
    if (run.contour == nullptr) {
      run.contour = std::make_shared<const ContourReport>(contour_report(run.shown->run, places, progress));
    }
  }
  return input;
}

std::vector<ReportRun> report_runs(const std::vector<std::shared_ptr<const ShownRun>>& runs) {
  std::set<std::string> machines;
  for (const auto& shown : runs) {
    machines.insert(shown->run.setup.machine.id);
  }
  const std::set<std::string> keys = differing_settings(runs);
  const std::set<AxisLimit> limits = differing_limits(runs);
  QStringList names;
  for (const auto& shown : runs) {
    names.append(name_of(shown->run, machines.size() > 1, keys, limits));
  }
  names = numbered(names);
  std::vector<ReportRun> named;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    named.push_back({runs[i], names[static_cast<qsizetype>(i)], run_colour(i)});
  }
  return named;
}

}  // namespace feedscope::ui
