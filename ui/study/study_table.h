#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "core/analysis/run/source_figures.h"
#include "core/analysis/study/study.h"

namespace feedscope::ui {

/// The runs of a study of one setting as rows; the ones to take are marked (recommended_marks).
class StudyTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// Columns of figures of drives and cutting load follow if any run has them.
  enum Column { value, cycle_time, mean_feed, contour_error, cause, columns };

  using QAbstractTableModel::QAbstractTableModel;

  /// Null for none.
  void set_study(std::shared_ptr<const Study> study);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(const StudyRun& run, int column) const;

  std::shared_ptr<const Study> study_;
  std::vector<bool> marks_;                   ///< by row
  std::vector<const SourceFigure*> figures_;  ///< after `columns`
};

/// The cause with the largest share of a run's time: "49 % jerk of axis X".
QString main_cause_text(const Summary& summary);

}  // namespace feedscope::ui
