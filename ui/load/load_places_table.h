#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/analysis/load/load_figures.h"

namespace feedscope::ui {

/// Places where the load exceeds a bound of its operation, in order of time.
class LoadPlacesTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { bound, worst, duration, lines, columns };

  using QAbstractTableModel::QAbstractTableModel;

  void set_limits(const std::vector<LimitFigures>& limits);
  const LoadPlace& place(int row) const { return rows_[static_cast<std::size_t>(row)].place; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    LoadLimit limit = LoadLimit::least_chip;
    LoadPlace place;
  };
  std::vector<Row> rows_;
};

}  // namespace feedscope::ui
