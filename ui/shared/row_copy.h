#pragma once

#include <QString>

class QAbstractItemModel;
class QAbstractItemView;

namespace feedscope::ui {

/// Headings and rows of a table as a spreadsheet takes them: cells with tabs between them, a line each.
QString rows_text(const QAbstractItemModel& table);

/// Ctrl+C in `table` copies all of it as rows_text(), not the one cell that has the focus.
void install_row_copy(QAbstractItemView& table);

}  // namespace feedscope::ui
