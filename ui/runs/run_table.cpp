#include "ui/runs/run_table.h"

#include <QFont>
#include <QLocale>
#include <algorithm>

#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/study/fastest_runs.h"
#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/signed_number.h"
#include "ui/language/texts.h"
#include "ui/shared/paths.h"
#include "ui/workbench/decision.h"
#include "ui/workbench/tolerance_text.h"

namespace feedscope::ui {

namespace {

QString number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

}  // namespace

RunTable::RunTable(RunList& runs, QObject* parent) : QAbstractTableModel(parent), runs_(runs) {
  connect(&runs_, &RunList::list_changed, this, &RunTable::reset);
  connect(&runs_, &RunList::item_changed, this, &RunTable::changed);
  connect(&runs_, &RunList::result_changed, this, &RunTable::all_changed);  // another run may be the best
  connect(&runs_, &RunList::current_changed, this, &RunTable::all_changed);
  connect(&runs_, &RunList::error_bound_changed, this, &RunTable::all_changed);
  connect(&runs_, &RunList::status_changed, this, &RunTable::changed);
}

void RunTable::set_traces(TraceList& traces) {
  traces_ = &traces;
  connect(&traces, &TraceList::list_changed, this, &RunTable::reset);
  connect(&traces, &TraceList::changed, this, &RunTable::all_changed);
  reset();
}

std::optional<std::size_t> RunTable::trace_of(int row) const {
  const auto runs = static_cast<int>(runs_.items().size());
  return row < runs ? std::nullopt : std::optional(static_cast<std::size_t>(row - runs));
}

void RunTable::reset() {
  beginResetModel();
  endResetModel();
  follow_figures();
}

void RunTable::changed(std::size_t row) {
  const int at = static_cast<int>(row);
  follow_figures();
  emit dataChanged(index(at, 0), index(at, columnCount() - 1));
}

void RunTable::all_changed() {
  follow_figures();
  emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

/// Adds columns with the first run that has their figure, and removes them with the last.
void RunTable::follow_figures() {
  const auto taken = runs_.items().size() > 1 ? recommended(runs_) : std::nullopt;
  taken_ = taken ? std::optional(taken->run) : std::nullopt;
  std::vector<std::shared_ptr<const ShownRun>> results;
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    results.push_back(runs_.result(row));
  }
  std::vector<const SourceFigure*> figures = source_figures_of(
      results, [](const auto& result) { return result != nullptr ? &result->run.summary : nullptr; });
  if (figures == figures_) {
    return;
  }
  if (!figures_.empty()) {
    beginRemoveColumns({}, columns, columnCount() - 1);
    figures_.clear();
    endRemoveColumns();
  }
  if (!figures.empty()) {
    beginInsertColumns({}, columns, columns + static_cast<int>(figures.size()) - 1);
    figures_ = std::move(figures);
    endInsertColumns();
  }
}

const Summary* RunTable::summary(std::size_t row) const {
  const auto result = runs_.result(row);
  return result != nullptr ? &result->run.summary : nullptr;
}

bool RunTable::refused(std::size_t row) const {
  const auto result = runs_.result(row);
  return result != nullptr && is_refused(result->run);
}

bool RunTable::out_of_reach(std::size_t row) const {
  const auto result = runs_.result(row);
  return result != nullptr && is_out_of_reach(result->run);
}

bool RunTable::counts(std::size_t row) const {
  return summary(row) != nullptr && !refused(row) && !out_of_reach(row);
}

std::size_t RunTable::lines_not_run(std::size_t row) const {
  const auto result = runs_.result(row);
  return result != nullptr ? result->run.lines_not_run.size() : 0;
}

bool RunTable::keeps_bound(const Summary& summary) const {
  return feedscope::keeps_bound(deciding_error(summary), runs_.error_bound());
}

std::vector<std::size_t> RunTable::fastest() const {
  std::vector<RunTime> times;
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    const Summary* figures = summary(row);
    times.push_back(figures == nullptr ? RunTime{0, 0, 0, false}
                                       : RunTime{figures->cycle_time, deciding_error(*figures),
                                                 lines_not_run(row), counts(row)});
  }
  return fastest_runs(times, runs_.error_bound());
}

int RunTable::rowCount(const QModelIndex& parent) const {
  const std::size_t traces = traces_ == nullptr ? 0 : traces_->items().size();
  return parent.isValid() ? 0 : static_cast<int>(runs_.items().size() + traces);
}

int RunTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns + static_cast<int>(figures_.size());
}

QString RunTable::figure(std::size_t row, int column) const {
  const Summary* figures = summary(row);
  if (figures == nullptr) {
    switch (runs_.status(row)) {
      case RunStatus::cancelled:
        return column == cycle_time ? tr("cancelled") : QString();
      case RunStatus::failed:
        return column == cycle_time ? tr("failed") : QString();
      default:
        return QStringLiteral("…");
    }
  }
  if (refused(row)) {
    return column == cycle_time ? tr("refused") : QStringLiteral("–");
  }
  if (out_of_reach(row) && column == cycle_time) {
    return tr("%1, out of reach").arg(clock_text(figures->cycle_time));
  }
  switch (column) {
    case cycle_time:
      return taken_ == row ? QStringLiteral("★ %1").arg(clock_text(figures->cycle_time))
                           : clock_text(figures->cycle_time);
    case difference: {
      const std::vector<std::size_t> best = fastest();
      if (best.empty() || std::ranges::find(best, row) != best.end() ||
          !(summary(best.front())->cycle_time > 0)) {
        return {};
      }
      if (!counts(row) || lines_not_run(row) > lines_not_run(best.front())) {
        return QStringLiteral("–");
      }
      const double percent = 100 * (figures->cycle_time / summary(best.front())->cycle_time - 1);
      return signed_number(percent, 1);
    }
    case mean_feed:
      return number_text(figures->mean_feed, Dimension::feed);
    case contour_error:
      return number_text(figures->cutting_contour_error, Dimension::error);
    default: {
      const SourceFigure& figure = *figures_[static_cast<std::size_t>(column - columns)];
      const std::optional<double> value = figure.of(*figures);
      return value ? number_text(*value, figure.dimension) : QStringLiteral("–");
    }
  }
}

QString RunTable::text(std::size_t row, int column) const {
  const RunItem& item = runs_.items()[row];
  const Setup& file = item.setup.file();
  switch (column) {
    case name:
      return runs_.items().size() > 1 ? run_letter(row) + ' ' + runs_.title(item) : runs_.title(item);
    case machine:
      return QString::fromStdString(file.machine.name);
    case model:
      return QString::fromStdString(file.model->info().id);
    case tolerance:
      return tolerance_range(runs_.tolerance(item));
    default:
      return figure(row, column);
  }
}

QString RunTable::explanation(std::size_t row) const {
  const RunItem& item = runs_.items()[row];
  QStringList lines{QStringLiteral("<b>%1</b>").arg(runs_.title(item).toHtmlEscaped()),
                    QString::fromStdString(item.setup.file().machine.name).toHtmlEscaped(),
                    core_text(item.setup.file().model->info().title).toHtmlEscaped()};
  if (const auto in_force = runs_.tolerance(item)) {
    lines.append(tolerance_origin(*in_force));
  }
  if (runs_.status(row) == RunStatus::cancelled) {
    lines.append(tr("It was cancelled and has no result. Simulate it again with F9."));
  } else if (runs_.status(row) == RunStatus::failed) {
    lines.append(tr("It failed: %1").arg(runs_.failure(row).toHtmlEscaped()));
  }
  if (refused(row)) {
    lines.append(
        tr("The control refuses the program: none of its feed motions is run, and there is no cycle time."));
  }
  if (out_of_reach(row)) {
    lines.append(
        tr("The program sends rotary axes where the machine cannot turn them: the time is not that of the "
           "program."));
  }
  if (const std::size_t not_run = lines_not_run(row); not_run > 0) {
    lines.append(tr("Lines that the control refuses and that are not run: %1.").arg(not_run));
  }
  const Summary* figures = refused(row) ? nullptr : summary(row);
  if (figures != nullptr && !keeps_bound(*figures)) {
    lines.append(tr("Its contour error of %1 is above the bound of %2.")
                     .arg(amount_text(deciding_error(*figures), Dimension::error),
                          amount_text(*runs_.error_bound(), Dimension::error)));
  }
  if (figures != nullptr && figures->max_contour_error > figures->cutting_contour_error) {
    lines.append(tr("In rapids it leaves the programmed path by up to %1.")
                     .arg(amount_text(figures->max_contour_error, Dimension::error)));
  }
  if (taken_ == row) {
    lines.append(tr("★ The run to take: %1").arg(DecisionTexts::decision(runs_).rule));
  }
  if (figures != nullptr) {
    append_slower_tolerance(row, lines);
  }
  return QStringLiteral("<p>%1</p>").arg(lines.join(QStringLiteral("<br>")));
}

void RunTable::append_slower_tolerance(std::size_t row, QStringList& lines) const {
  std::vector<ToleranceRun> runs;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < runs_.items().size(); ++i) {
    if (counts(i)) {
      runs.push_back({&runs_.result(i)->run.setup, summary(i)});
      rows.push_back(i);
    }
  }
  for (const SlowerTolerance& slower : slower_with_wider_tolerance(runs)) {
    if (rows[slower.wide] == row) {
      lines.append(slower_tolerance_text(slower).toHtmlEscaped());
    }
  }
}

QString RunTable::trace_text(std::size_t trace, int column) const {
  const auto shown = traces_->result(trace);
  switch (column) {
    case name:
      return traces_->items()[trace].name;
    case machine:
      return tr("recorded");
    case cycle_time:
      if (shown == nullptr) {
        switch (traces_->status(trace)) {
          case TraceStatus::cancelled:
            return tr("cancelled");
          case TraceStatus::failed:
            return tr("failed");
          default:
            return QStringLiteral("…");
        }
      }
      return shown->agreement.whole ? clock_text(shown->agreement.measured_time) : QStringLiteral("–");
    case difference: {
      const std::vector<std::size_t> best = fastest();
      if (shown == nullptr || !shown->agreement.whole || best.empty() ||
          !(summary(best.front())->cycle_time > 0)) {
        return {};
      }
      const double percent = 100 * (shown->agreement.measured_time / summary(best.front())->cycle_time - 1);
      return signed_number(percent, 1);
    }
    case contour_error:
      return shown == nullptr ? QStringLiteral("…")
                              : number_text(shown->agreement.distance, Dimension::error);
    default:
      return QStringLiteral("–");
  }
}

QString RunTable::trace_explanation(std::size_t trace) const {
  const TraceItem& item = traces_->items()[trace];
  QStringList lines{QStringLiteral("<b>%1</b>").arg(item.name.toHtmlEscaped()),
                    to_qstring(item.file).toHtmlEscaped(),
                    tr("What a control recorded. The panel Trace says how well the current run agrees.")};
  const auto shown = traces_->result(trace);
  if (shown != nullptr && !shown->agreement.whole) {
    lines.append(tr("It covers %1 % of the path: a cycle time is not known.")
                     .arg(number(100 * shown->found.share, 1)));
  }
  if (traces_->status(trace) == TraceStatus::failed) {
    lines.append(tr("It failed: %1").arg(traces_->failure(trace).toHtmlEscaped()));
  }
  return QStringLiteral("<p>%1</p>").arg(lines.join(QStringLiteral("<br>")));
}

QVariant RunTable::trace_data(std::size_t trace, int column, int role) const {
  const TraceItem& item = traces_->items()[trace];
  switch (role) {
    case Qt::DisplayRole:
      return trace_text(trace, column);
    case Qt::EditRole:
      return column == name ? QVariant(item.name) : QVariant();
    case Qt::CheckStateRole:
      return column == name ? QVariant(item.visible ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole:
      return column == name ? QVariant(item.colour) : QVariant();
    case Qt::TextAlignmentRole:
      return column >= tolerance ? QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ToolTipRole:
      return trace_explanation(trace);
    case Qt::FontRole: {
      QFont font;
      font.setItalic(true);
      return font;
    }
    default:
      return {};
  }
}

QVariant RunTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  if (const auto trace = trace_of(index.row())) {
    return trace_data(*trace, index.column(), role);
  }
  const auto row = static_cast<std::size_t>(index.row());
  const RunItem& item = runs_.items()[row];
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case Qt::EditRole:
      return index.column() == name ? QVariant(runs_.title(item)) : QVariant();
    case Qt::CheckStateRole:
      return index.column() == name ? QVariant(item.visible ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole:
      return index.column() == name ? QVariant(item.colour) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() >= tolerance ? QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter)
                                         : QVariant();
    case Qt::ToolTipRole:
      return explanation(row);
    case Qt::FontRole: {
      QFont font;
      font.setBold(row == runs_.current());
      const Summary* figures = summary(row);
      font.setStrikeOut(index.column() == contour_error && figures != nullptr && !refused(row) &&
                        !keeps_bound(*figures));
      return font;
    }
    default:
      return {};
  }
}

bool RunTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || index.column() != name) {
    return false;
  }
  if (const auto trace = trace_of(index.row())) {
    if (role == Qt::CheckStateRole) {
      traces_->set_visible(*trace, value.value<Qt::CheckState>() == Qt::Checked);
    } else if (role == Qt::EditRole) {
      traces_->rename(*trace, value.toString());
    }
    return role == Qt::CheckStateRole || role == Qt::EditRole;
  }
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::CheckStateRole) {
    runs_.set_visible(row, value.value<Qt::CheckState>() == Qt::Checked);
    return true;
  }
  if (role == Qt::EditRole) {
    if (value.toString() != runs_.title(runs_.items()[row])) {
      runs_.rename(row, value.toString());
    }
    return true;
  }
  return false;
}

Qt::ItemFlags RunTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() && index.column() == name ? flags | Qt::ItemIsEditable | Qt::ItemIsUserCheckable
                                                   : flags;
}

QVariant RunTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) {
    return {};
  }
  if (section >= columns) {
    const SourceFigure& figure = *figures_[static_cast<std::size_t>(section - columns)];
    return role == Qt::DisplayRole   ? with_unit_of(core_text(std::string(figure.title)), figure.dimension)
           : role == Qt::ToolTipRole ? core_text(std::string(figure.meaning))
                                     : QVariant();
  }
  static const std::array titles{QT_TR_NOOP("Run"),       QT_TR_NOOP("Machine"),    QT_TR_NOOP("Model"),
                                 QT_TR_NOOP("Tolerance"), QT_TR_NOOP("Cycle time"), QT_TR_NOOP("Slower [%]"),
                                 QT_TR_NOOP("Mean feed"), QT_TR_NOOP("Error")};
  static const std::array tips{
      QT_TR_NOOP("Name of the run; the box shows its path and feed together with those of the current run"),
      QT_TR_NOOP("Machine whose axis limits apply"),
      QT_TR_NOOP("Control model"),
      QT_TR_NOOP("Contour tolerance in force, from the program or the setting"),
      QT_TR_NOOP("Cycle time [s, or min:s]; the star marks the fastest run within the error bound"),
      QT_TR_NOOP("Cycle time above that of the fastest run [%]"),
      QT_TR_NOOP("Mean feed with rapids: executed path over cycle time without dwells"),
      QT_TR_NOOP("Largest distance of the executed path from the programmed one in feed motions")};
  const auto i = static_cast<std::size_t>(section);
  if (role == Qt::DisplayRole) {
    return with_unit_of(tr(titles[i]), section == tolerance       ? Dimension::length
                                       : section == mean_feed     ? Dimension::feed
                                       : section == contour_error ? Dimension::error
                                                                  : Dimension::number);
  }
  return role == Qt::ToolTipRole ? QVariant(tr(tips[i])) : QVariant();
}

}  // namespace feedscope::ui
