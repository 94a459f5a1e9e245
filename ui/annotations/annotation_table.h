#pragma once

#include <QAbstractTableModel>
#include <functional>

#include "ui/workbench/annotation_list.h"

namespace feedscope::ui {

/// The annotations as rows: kind, line of the program, text with its values. The tooltip has the text as
/// written.
class AnnotationTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kind, line, text, columns };

  /// `list` outlives this.
  explicit AnnotationTable(AnnotationList& list, QObject* parent = nullptr);

  /// The program of the lines; null for none.
  void set_toolpath(std::shared_ptr<const Toolpath> toolpath);
  /// Sets the function that fills in the values of the run; without it texts remain as written.
  void set_teller(std::function<QString(const Annotation&)> teller);
  /// The values of the run have changed.
  void refresh_texts();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString line_of(const Annotation& annotation) const;

  AnnotationList& list_;
  int rows_ = 0;
  std::shared_ptr<const Toolpath> toolpath_;
  std::function<QString(const Annotation&)> teller_;
};

}  // namespace feedscope::ui
