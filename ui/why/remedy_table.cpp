#include "ui/why/remedy_table.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/language/remedy_text.h"
#include "ui/language/texts.h"
#include "ui/language/time_texts.h"

namespace feedscope::ui {

namespace {

constexpr double nothing = 5e-4;  // a gain that no digit shows [s]

/// "" where it would be 0.0.
QString percent_text(double change, double of) {
  constexpr double least = 0.05;
  const double percent = of > 0 ? 100 * std::abs(change) / of : 0;
  if (std::abs(change) < nothing || percent < least) {
    return {};
  }
  const QString amount = QLocale().toString(percent, 'f', 1);
  return QStringLiteral("%1%2 %").arg(QString(QChar(change < 0 ? 0x2212 : '+')), amount);
}

}  // namespace

void RemedyTable::begin(const Setup& setup, const std::vector<Remedy>& remedies, const RemedyTrial& before) {
  beginResetModel();
  before_ = before;
  rows_.clear();
  for (const Remedy& remedy : remedies) {
    rows_.push_back({rows_.size(), remedy, remedy_text(remedy, setup), std::nullopt});
  }
  endResetModel();
}

void RemedyTable::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

void RemedyTable::set_trial(std::size_t remedy, const RemedyTrial& trial) {
  const auto row = std::ranges::find(rows_, remedy, &Row::number);
  if (row == rows_.end()) {
    return;
  }
  row->trial = trial;
  const int at = static_cast<int>(row - rows_.begin());
  emit dataChanged(index(at, 0), index(at, columns - 1));
}

double RemedyTable::gain_of(const Row& row) const {
  return is_done(row) ? before_.cycle_time - row.trial->cycle_time : -std::numeric_limits<double>::infinity();
}

void RemedyTable::sort_by_gain() {
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  std::vector<std::size_t> numbers;
  for (const Row& row : rows_) {
    numbers.push_back(row.number);
  }
  std::ranges::stable_sort(rows_, [this](const Row& a, const Row& b) { return gain_of(a) > gain_of(b); });
  QModelIndexList after;
  for (const QModelIndex& old : before) {
    const auto moved = std::ranges::find(rows_, numbers[static_cast<std::size_t>(old.row())], &Row::number);
    after.append(index(static_cast<int>(moved - rows_.begin()), old.column()));
  }
  changePersistentIndexList(before, after);
  emit layoutChanged();
}

const Remedy* RemedyTable::remedy(int row) const {
  return row >= 0 && row < rowCount() ? &rows_[static_cast<std::size_t>(row)].remedy : nullptr;
}

int RemedyTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int RemedyTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QString RemedyTable::text(const Row& row, int column) const {
  if (column == change) {
    return row.title;
  }
  if (!is_done(row)) {
    return row.trial ? QStringLiteral("–") : QStringLiteral("…");
  }
  const double total = row.trial->cycle_time - before_.cycle_time;
  const double passage = row.trial->passage_time - before_.passage_time;
  switch (column) {
    case cycle_time:
      return clock_text(row.trial->cycle_time);
    case gain:
      return QStringLiteral("%1\n%2")
          .arg(TimeTexts::change(total), percent_text(total, before_.cycle_time))
          .trimmed();
    default:
      return QStringLiteral("%1\n%2")
          .arg(TimeTexts::change(passage), percent_text(passage, before_.passage_time))
          .trimmed();
  }
}

QString RemedyTable::explanation(const Row& row) const {
  if (row.trial && !row.trial->failure.isEmpty()) {
    return row.trial->failure;
  }
  if (!row.trial) {
    return tr("%1: being simulated").arg(row.title);
  }
  return tr("%1: the program takes %2 instead of %3, the place at the cursor %4 instead of %5")
      .arg(row.title, clock_text(row.trial->cycle_time), clock_text(before_.cycle_time),
           clock_text(row.trial->passage_time), clock_text(before_.passage_time));
}

QVariant RemedyTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case Qt::ToolTipRole:
      return explanation(row);
    case Qt::TextAlignmentRole:
      return QVariant((index.column() == change ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant RemedyTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant((section == change ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case cycle_time:
        return tr("Cycle time with the change");
      case gain:
        return tr("Change in cycle time: shorter (−) or longer (+)");
      case here:
        return tr("The same for the blocks around the cursor");
      default:
        return tr("The change; double-click to make it a new run");
    }
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case change:
      return tr("Change");
    case cycle_time:
      return tr("Time");
    case gain:
      return tr("Total");
    default:
      return tr("Here");
  }
}

}  // namespace feedscope::ui
