#pragma once

#include <QAbstractItemView>
#include <QList>
#include <QString>
#include <optional>

#include "core/lessons/lesson.h"
#include "ui/session/session.h"

namespace feedscope::ui {

class MainWindow;

/// A table of a panel.
struct PrintedTable {
  QString title;  ///< of its panel
  const QAbstractItemView* view = nullptr;
  bool has_focus = false;
};

/// Printable contents of the window.
struct PrintSubject {
  std::optional<Session> session;  ///< of the open program; none without one
  const Lesson* lesson = nullptr;  ///< the open one; may be null
  QList<PrintedTable> tables;      ///< visible ones with rows
  QString language;                ///< of the window
};

/// Contents of `window` in its current state; pointers are to objects of the window.
PrintSubject print_subject(MainWindow& window);

/// A table as HTML: title, headings and the rows as in the view, as text.
QString table_page(const QString& title, const QAbstractItemModel& table);

}  // namespace feedscope::ui
