#pragma once

#include <QStyledItemDelegate>

namespace feedscope::ui {

/// Editors for the cells of a table: a list for a cell with choices, else a line.
class ChoiceDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// QStringList of the values that a cell can take; empty: any.
  static constexpr int choices_role = Qt::UserRole;

  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 private:
  void commit_choice();
};

}  // namespace feedscope::ui
