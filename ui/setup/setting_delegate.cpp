#include "ui/setup/setting_delegate.h"

#include <QComboBox>

#include "ui/setup/setup_tables.h"

namespace feedscope::ui {

QWidget* SettingDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                       const QModelIndex& index) const {
  const QStringList choices = index.data(SetupTable::choices_role).toStringList();
  if (choices.isEmpty()) {
    return QStyledItemDelegate::createEditor(parent, option, index);
  }
  auto* box = new QComboBox(parent);
  box->addItems(choices);
  connect(box, &QComboBox::activated, this, &SettingDelegate::commit_choice);
  return box;
}

void SettingDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    box->setCurrentText(index.data(Qt::EditRole).toString());
  } else {
    QStyledItemDelegate::setEditorData(editor, index);
  }
}

void SettingDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                   const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    model->setData(index, box->currentText());
  } else {
    QStyledItemDelegate::setModelData(editor, model, index);
  }
}

void SettingDelegate::commit_choice() {
  auto* box = qobject_cast<QComboBox*>(sender());
  emit commitData(box);
  emit closeEditor(box);
}

}  // namespace feedscope::ui
