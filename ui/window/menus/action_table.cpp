#include "ui/window/menus/action_table.h"

#include <QColor>
#include <utility>

#include "ui/shared/panel_action.h"

namespace feedscope::ui {

QString plain_text(const QString& menu_text) {
  QString text = menu_text;
  text.remove(QStringLiteral(" …")).replace(QStringLiteral("&&"), QStringLiteral("\x01"));
  text.remove('&').replace(QStringLiteral("\x01"), QStringLiteral("&"));
  return text;
}

void ActionTable::set_actions(QList<ListedAction> actions) {
  beginResetModel();
  actions_ = std::move(actions);
  endResetModel();
}

QAction* ActionTable::action(const QModelIndex& index) const {
  return index.isValid() ? actions_[index.row()].action : nullptr;
}

int ActionTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(actions_.size());
}

int ActionTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant ActionTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const ListedAction& listed = actions_[index.row()];
  if (role == Qt::ToolTipRole) {
    return listed.action->toolTip();
  }
  if (role == words_role) {
    return listed.action->property(everyday_words_property);
  }
  if (role == Qt::DecorationRole && index.column() == name) {
    return listed.action->icon();
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
    case place:
      return listed.place;
    case name: {
      const QString text = plain_text(listed.action->text());
      return listed.action->isChecked() ? QStringLiteral("✓ %1").arg(text) : text;
    }
    default:
      return QKeySequence::listToString(listed.action->shortcuts(), QKeySequence::NativeText);
  }
}

QVariant ActionTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case place:
      return tr("Menu");
    case name:
      return tr("Command");
    case keys:
      return tr("Shortcut");
    default:
      return {};
  }
}

}  // namespace feedscope::ui
