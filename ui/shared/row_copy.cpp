#include "ui/shared/row_copy.h"

#include <QAbstractItemView>
#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

namespace feedscope::ui {

namespace {

struct RowCopy {
  Q_DECLARE_TR_FUNCTIONS(RowCopy)
};

}  // namespace

QString rows_text(const QAbstractItemModel& table) {
  const auto line = [&](auto cell) {
    QStringList cells;
    for (int column = 0; column < table.columnCount(); ++column) {
      cells.append(cell(column).toString().simplified());
    }
    return cells.join('\t') + '\n';
  };
  QString text = line([&](int column) { return table.headerData(column, Qt::Horizontal); });
  for (int row = 0; row < table.rowCount(); ++row) {
    text += line([&](int column) { return table.index(row, column).data(); });
  }
  return text;
}

void install_row_copy(QAbstractItemView& table) {
  auto* copy = new QAction(RowCopy::tr("&Copy the table"), &table);
  copy->setToolTip(RowCopy::tr("Copy all rows to the clipboard for pasting into a spreadsheet"));
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  QObject::connect(copy, &QAction::triggered, &table,
                   [&table] { QGuiApplication::clipboard()->setText(rows_text(*table.model())); });
  table.addAction(copy);
}

}  // namespace feedscope::ui
