#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "core/analysis/load/load_figures.h"

namespace feedscope::ui {

/// Largest and mean load at the predicted and at the programmed feed, one row for each quantity.
class LoadFiguresTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { quantity, largest, line, mean, programmed_largest, programmed_mean, columns };

  using QAbstractTableModel::QAbstractTableModel;

  /// None: no rows.
  void set_totals(std::optional<LoadTotals> totals);
  /// Time of the largest value of a row at the predicted feed [s].
  double time_of(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::optional<LoadTotals> totals_;
};

}  // namespace feedscope::ui
