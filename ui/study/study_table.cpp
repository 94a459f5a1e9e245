#include "ui/study/study_table.h"

#include <QFont>
#include <QLocale>
#include <utility>

#include "core/analysis/study/recommendation.h"
#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

QString main_cause_text(const Summary& summary) {
  const std::vector<CauseShare> causes = limiting_causes(summary);
  return causes.empty()
             ? QString()
             : StudyTable::tr("%1 % %2").arg(QLocale().toString(100 * causes.front().share, 'f', 0),
                                             shown_cause(causes.front().cause));
}

void StudyTable::set_study(std::shared_ptr<const Study> study) {
  beginResetModel();
  study_ = std::move(study);
  figures_.clear();
  marks_.clear();
  if (study_ != nullptr) {
    marks_ = recommended_marks(study_->runs, study_->within);
    figures_ = source_figures_of(study_->runs, [](const StudyRun& run) { return &run.summary; });
  }
  endResetModel();
}

int StudyTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || study_ == nullptr ? 0 : static_cast<int>(study_->runs.size());
}

int StudyTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns + static_cast<int>(figures_.size());
}

QVariant StudyTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const auto row = static_cast<std::size_t>(index.row());
  const StudyRun& run = study_->runs[row];
  const bool best = marks_[row];
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == cycle_time && best ? QStringLiteral("★ ") + text(run, cycle_time)
                                                  : text(run, index.column());
    case Qt::TextAlignmentRole:
      return QVariant::fromValue((index.column() == cause ? Qt::AlignLeft : Qt::AlignRight) |
                                 Qt::AlignVCenter);
    case Qt::FontRole: {
      QFont font;
      font.setBold(best);
      return font;
    }
    case Qt::ToolTipRole:
      return best               ? tr("Recommended: the smallest error among those within 1 % of the fastest")
             : run.out_of_reach ? tr("The program sends rotary axes where the machine cannot turn them.")
                                : QVariant();
    default:
      return {};
  }
}

QString StudyTable::text(const StudyRun& run, int column) const {
  const QLocale locale;
  const Summary& summary = run.summary;
  if (!run.is_possible() && column != value) {
    return column != cycle_time ? QStringLiteral("–") : run.refused ? tr("refused") : tr("out of reach");
  }
  switch (column) {
    case value:
      return locale.toString(run.swept.front() * key_unit(sweep_unit(study_->sweeps.front().key)).factor, 'g',
                             5);
    case cycle_time:
      return clock_text(summary.cycle_time);
    case mean_feed:
      return number_text(summary.mean_feed, Dimension::feed);
    case contour_error:
      return number_text(deciding_error(summary), Dimension::error);
    case cause:
      return main_cause_text(summary);
    default: {
      const SourceFigure& figure = *figures_[static_cast<std::size_t>(column - columns)];
      const std::optional<double> number = figure.of(summary);
      return number ? number_text(*number, figure.dimension) : QStringLiteral("–");
    }
  }
}

QVariant StudyTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == mean_feed) {
    return tr("Mean feed with rapids: executed path over cycle time without dwells");
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  const QString unit = study_ == nullptr ? QString() : key_unit(sweep_unit(study_->sweeps.front().key)).text;
  switch (section) {
    case value:
      return unit.isEmpty() ? tr("Value") : tr("Value [%1]").arg(unit);
    case cycle_time:
      return tr("Cycle time");
    case mean_feed:
      return with_unit_of(tr("Mean feed"), Dimension::feed);
    case contour_error:
      return with_unit_of(tr("Error"), Dimension::error);
    case cause:
      return tr("Mainly limited by");
    default: {
      const SourceFigure& figure = *figures_[static_cast<std::size_t>(section - columns)];
      return with_unit_of(core_text(std::string(figure.title)), figure.dimension);
    }
  }
}

}  // namespace feedscope::ui
