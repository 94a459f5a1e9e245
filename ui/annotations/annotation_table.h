#pragma once

#include <QAbstractTableModel>

#include "ui/workbench/annotation_list.h"

namespace feedscope::ui {

/// The annotations as rows: kind, line of the program, text as it was written.
class AnnotationTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kind, line, text, columns };

  /// `list` outlives this.
  explicit AnnotationTable(AnnotationList& list, QObject* parent = nullptr);

  /// What the lines are of; null for none.
  void set_toolpath(std::shared_ptr<const Toolpath> toolpath);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString line_of(const Annotation& annotation) const;

  AnnotationList& list_;
  int rows_ = 0;
  std::shared_ptr<const Toolpath> toolpath_;
};

}  // namespace feedscope::ui
