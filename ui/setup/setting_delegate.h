#pragma once

#include <QStyledItemDelegate>

namespace feedscope::ui {

/// Editors for the cells of a SetupTable: a line for numbers, a list for choices.
class SettingDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 private:
  void commit_choice();
};

}  // namespace feedscope::ui
