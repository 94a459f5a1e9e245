#include "ui/report/report_input.h"

#include <QLocale>
#include <algorithm>
#include <set>

#include "core/machine/contour_tolerance.h"
#include "ui/models/run_list.h"
#include "ui/models/tolerance_text.h"

namespace feedscope::ui {

namespace {

QString value_text(const SettingValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? QLocale().toString(*number, 'g', 6)
                           : QString::fromStdString(std::get<std::string>(value));
}

/// Keys of settings that do not have the same value in all runs of their model.
std::set<std::string> differing_settings(const std::vector<std::shared_ptr<const ShownRun>>& runs) {
  std::set<std::string> keys;
  for (const auto& a : runs) {
    for (const auto& b : runs) {
      const Setup& one = a->run.setup;
      const Setup& other = b->run.setup;
      for (const auto& [key, value] : one.settings.values()) {
        const auto found = other.settings.values().find(key);
        if (one.model == other.model && found != other.settings.values().end() && found->second != value) {
          keys.insert(key);
        }
      }
    }
  }
  return keys;
}

QString name_of(const Run& run, bool with_machine, const std::set<std::string>& keys) {
  const Setup& setup = run.setup;
  QStringList parts;
  if (with_machine) {
    parts.append(QString::fromStdString(setup.machine.id));
  }
  parts.append(QString::fromStdString(setup.model->info().id));
  if (const auto tolerance = tolerance_in_force(run.input.feed_controls, setup)) {
    parts.append(tolerance_text(*tolerance));
  }
  for (const std::string& key : keys) {
    const bool said = key == contour_tolerance_key || key == program_tolerance_key;
    if (!said && setup.settings.has(key)) {
      parts.append(QStringLiteral("%1 %2").arg(QString::fromStdString(key),
                                               value_text(setup.settings.values().at(key))));
    }
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace

QString program_file_name(const Program& program) {
  return QString::fromStdString(program.source->name()).section('/', -1);
}

QString ReportInput::heading() const {
  return title.isEmpty() ? program_file_name(*program().program) : title;
}

ReportInput with_contour_reports(ReportInput input, Progress* progress) {
  constexpr std::size_t places = 100;  // those that are alike stand together
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
  std::vector<ReportRun> named;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    QString name = name_of(runs[i]->run, machines.size() > 1, keys);
    const auto same = std::ranges::count(named, name, &ReportRun::name);
    if (same > 0) {
      name += QStringLiteral(" (%1)").arg(i + 1);
    }
    named.push_back({runs[i], name, run_colour(i)});
  }
  return named;
}

}  // namespace feedscope::ui
