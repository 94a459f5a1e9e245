#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/analysis/contour/contour_report.h"

namespace feedscope::ui {

/// The places of a run with the largest contour errors, the worst first; places out of tolerance are bold.
class ContourPlacesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { rank, line, error, share, side, spot, feed, cause, columns };

  using QAbstractTableModel::QAbstractTableModel;

  /// Null: none.
  void set_report(std::shared_ptr<const ContourReport> report);

  const ContourReport* report() const { return report_.get(); }
  const ContourFinding& finding(int row) const { return report_->worst[static_cast<std::size_t>(row)]; }
  /// The row of the next (or previous) place after a time [s]; after the last one, the first.
  /// -1: the list is empty.
  int next_row(double time, bool forward) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(int row, int column) const;
  QString tip(const ContourFinding& finding) const;

  std::shared_ptr<const ContourReport> report_;
};

}  // namespace feedscope::ui
