#pragma once

#include <QAbstractItemView>
#include <QList>
#include <QString>
#include <optional>

#include "core/lessons/lesson.h"
#include "ui/session/session.h"

namespace feedscope::ui {

class MainWindow;

/// A table that a panel shows.
struct PrintedTable {
  QString title;  ///< of its panel
  const QAbstractItemView* view = nullptr;
  bool has_focus = false;
};

/// What the window has to print.
struct PrintSubject {
  std::optional<Session> session;  ///< of the program that is open; none: there is none
  const Lesson* lesson = nullptr;  ///< that is open; may be null
  QList<PrintedTable> tables;      ///< that can be seen, with rows
  QString language;                ///< of the window
};

/// Of `window` as it is now; what it points to belongs to the window.
PrintSubject print_subject(MainWindow& window);

/// A table as HTML: title, headings and the rows that the view shows, as text.
QString table_page(const QString& title, const QAbstractItemModel& table);

}  // namespace feedscope::ui
