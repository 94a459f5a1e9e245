#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/analysis/circularity/circular_test.h"

namespace feedscope::ui {

/// Circular tests as a table, a row for each direction; for a program with the lines and the centre of each
/// circle.
class CircularTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// `line` and `center` exist for circles of a program only.
  enum Column {
    line,
    center,
    radius,
    feed,
    reached,
    direction,
    zone,
    squares,
    largest,
    smallest,
    mean,
    both,
    d,
    columns
  };

  using QAbstractTableModel::QAbstractTableModel;

  void set_tests(std::vector<CircularTest> tests);
  const std::vector<CircularTest>& tests() const { return tests_; }
  /// The test of a row; its other direction may be a second row.
  const CircularTest& test_of(int row) const { return tests_[rows_[static_cast<std::size_t>(row)].test]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::size_t test = 0;
    std::size_t pass = 0;
  };
  QString text(const Row& row, int column) const;

  std::vector<CircularTest> tests_;
  std::vector<Row> rows_;
};

}  // namespace feedscope::ui
