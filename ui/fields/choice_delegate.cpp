#include "ui/fields/choice_delegate.h"

#include <QComboBox>

namespace feedscope::ui {

QWidget* ChoiceDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                      const QModelIndex& index) const {
  const QStringList choices = index.data(choices_role).toStringList();
  if (choices.isEmpty()) {
    return QStyledItemDelegate::createEditor(parent, option, index);
  }
  auto* box = new QComboBox(parent);
  box->addItems(choices);
  connect(box, &QComboBox::activated, this, &ChoiceDelegate::commit_choice);
  return box;
}

void ChoiceDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    box->setCurrentText(index.data(Qt::EditRole).toString());
  } else {
    QStyledItemDelegate::setEditorData(editor, index);
  }
}

void ChoiceDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                  const QModelIndex& index) const {
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    model->setData(index, box->currentText());
  } else {
    QStyledItemDelegate::setModelData(editor, model, index);
  }
}

void ChoiceDelegate::commit_choice() {
  auto* box = qobject_cast<QComboBox*>(sender());
  emit commitData(box);
  emit closeEditor(box);
}

}  // namespace feedscope::ui
