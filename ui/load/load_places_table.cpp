#include "ui/load/load_places_table.h"

#include <algorithm>

#include "ui/language/shown_numbers.h"
#include "ui/load/load_texts.h"

namespace feedscope::ui {

void LoadPlacesTable::set_limits(const std::vector<LimitFigures>& limits) {
  beginResetModel();
  rows_.clear();
  for (const LimitFigures& limit : limits) {
    for (const LoadPlace& place : limit.places) {
      rows_.push_back({limit.limit, place});
    }
  }
  std::ranges::stable_sort(rows_, {}, [](const Row& row) { return row.place.from; });
  endResetModel();
}

int LoadPlacesTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int LoadPlacesTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant LoadPlacesTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignVCenter | (index.column() == bound ? Qt::AlignLeft : Qt::AlignRight));
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case bound:
      return limit_text(row.limit);
    case worst:
      return amount_text(row.place.worst, info_of(load_quantities()[quantity_of(row.limit)].id).dimension);
    case duration:
      return amount_text(row.place.to - row.place.from, Dimension::time);
    default:
      return row.place.first_line == row.place.last_line
                 ? QString::number(row.place.first_line)
                 : tr("%1 – %2").arg(QString::number(row.place.first_line),
                                     QString::number(row.place.last_line));
  }
}

QVariant LoadPlacesTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case bound:
      return tr("Beyond a bound");
    case worst:
      return tr("Worst");
    case duration:
      return tr("For");
    default:
      return tr("Lines");
  }
}

}  // namespace feedscope::ui
