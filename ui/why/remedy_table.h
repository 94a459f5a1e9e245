#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "ui/why/remedy_job.h"

namespace feedscope::ui {

/// Changes tried on a run and their gains: one row each, the largest gain first once all are tried.
class RemedyTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { change, cycle_time, gain, here, columns };

  using QAbstractTableModel::QAbstractTableModel;

  /// `before`: cycle time and passage time of the run itself.
  void begin(const Setup& setup, const std::vector<Remedy>& remedies, const RemedyTrial& before);
  void clear();
  void set_trial(std::size_t remedy, const RemedyTrial& trial);
  /// Sorts by gain, rows without a result last.
  void sort_by_gain();
  /// The remedy of a row; none for a missing row.
  const Remedy* remedy(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    std::size_t number = 0;  ///< index of the remedy in the request
    Remedy remedy;
    QString title;
    std::optional<RemedyTrial> trial;
  };

  QString text(const Row& row, int column) const;
  QString explanation(const Row& row) const;
  double gain_of(const Row& row) const;  ///< [s]
  static bool is_done(const Row& row) { return row.trial && row.trial->failure.isEmpty(); }

  std::vector<Row> rows_;
  RemedyTrial before_;
};

}  // namespace feedscope::ui
