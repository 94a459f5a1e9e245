#pragma once

#include <QTableWidgetItem>

namespace feedscope::ui {

/// A read-only cell; its table owns it.
inline QTableWidgetItem* fixed_item(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  return item;
}

}  // namespace feedscope::ui
