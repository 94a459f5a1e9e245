#include "ui/load/load_figures_table.h"

#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

void LoadFiguresTable::set_totals(std::optional<LoadTotals> totals) {
  beginResetModel();
  totals_ = totals && totals->cutting_time > 0 ? std::move(totals) : std::nullopt;
  endResetModel();
}

double LoadFiguresTable::time_of(int row) const {
  return totals_->predicted[static_cast<std::size_t>(row)].time;
}

int LoadFiguresTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !totals_ ? 0 : static_cast<int>(load_quantity_count);
}

int LoadFiguresTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant LoadFiguresTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignVCenter | (index.column() == quantity ? Qt::AlignLeft : Qt::AlignRight));
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  const auto row = static_cast<std::size_t>(index.row());
  const QuantityInfo& info = info_of(load_quantities()[row].id);
  const LoadFigure& predicted = totals_->predicted[row];
  const LoadFigure& programmed = totals_->programmed[row];
  switch (index.column()) {
    case quantity:
      return core_text(std::string(info.title));
    case largest:
      return amount_text(predicted.largest, info.dimension);
    case line:
      return QString::number(predicted.line);
    case mean:
      return amount_text(predicted.mean, info.dimension);
    case programmed_largest:
      return amount_text(programmed.largest, info.dimension);
    default:
      return amount_text(programmed.mean, info.dimension);
  }
}

QVariant LoadFiguresTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  const bool title = role == Qt::DisplayRole;
  switch (section) {
    case quantity:
      return title ? tr("Load") : QVariant();
    case largest:
      return title ? tr("Largest") : tr("At the feed that the control reaches");
    case line:
      return title ? tr("In line") : tr("Where the load is the largest; a click goes there");
    case mean:
      return title ? tr("Mean") : tr("Over the time of cutting");
    case programmed_largest:
      return title ? tr("Programmed, largest") : tr("If the tool ran at the programmed feed everywhere");
    default:
      return title ? tr("Programmed, mean") : tr("Over the time that this would take");
  }
}

}  // namespace feedscope::ui
