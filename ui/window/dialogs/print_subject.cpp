#include "ui/window/dialogs/print_subject.h"

#include <QDockWidget>

#include "ui/language/language.h"
#include "ui/lessons/lesson_view.h"
#include "ui/paper/html_table.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {

namespace {

constexpr const char* table_style =
    "body { font-size: 11px; } h1 { font-size: 18px; margin: 0 0 10px; } table { border-collapse: collapse; "
    "} "
    "th { text-align: left; border-bottom: 1px solid #444; padding: 2px 8px 2px 0; } "
    "td { border-bottom: 1px solid #ccc; padding: 2px 8px 2px 0; }";

}  // namespace

PrintSubject print_subject(MainWindow& window) {
  PrintSubject subject;
  if (window.workbench().program() != nullptr) {
    subject.session = window.session().capture();
  }
  subject.lesson = window.part<LessonView>().desk().lesson();
  subject.language = chosen_language();
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
    for (const QAbstractItemView* view : dock->findChildren<QAbstractItemView*>()) {
      const bool seen = view->isVisible() && !view->visibleRegion().isEmpty();
      if (seen && view->model() != nullptr && view->model()->rowCount() > 0 &&
          view->model()->columnCount() > 1) {
        subject.tables.append({dock->windowTitle(), view, view->hasFocus()});
      }
    }
  }
  return subject;
}

QString table_page(const QString& title, const QAbstractItemModel& table) {
  return QStringLiteral("<html><head><style>%1</style></head><body><h1>%2</h1>%3</body></html>")
      .arg(QString::fromLatin1(table_style), title.toHtmlEscaped(), html_of_model(table));
}

}  // namespace feedscope::ui
