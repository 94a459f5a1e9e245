#pragma once

#include <QString>

class QAbstractItemModel;
class QAbstractItemView;

namespace feedscope::ui {

/// Headings and rows of a table for a spreadsheet: cells separated by tabs, one line per row.
QString rows_text(const QAbstractItemModel& table);

/// Makes Ctrl+C in `table` copy all of it as rows_text() instead of the cell with the focus.
void install_row_copy(QAbstractItemView& table);

}  // namespace feedscope::ui
