#include "ui/window/lesson_menu.h"

#include <algorithm>

namespace feedscope::ui {

namespace {

constexpr std::size_t lessons_a_menu = 9;

}  // namespace

LessonMenu::LessonMenu(LessonDesk& desk, const QList<QAction*>& commands, const QList<QAction*>& handouts,
                       QWidget* parent)
    : QMenu(tr("&Lessons"), parent), desk_(desk), behind_lessons_(addSeparator()) {
  addMenu(tr("&This lesson"))->addActions(commands);
  addMenu(tr("&Hand-outs"))->addActions(handouts);
  connect(&desk_, &LessonDesk::listed, this, &LessonMenu::list);
  list();
  desk_.list();
}

void LessonMenu::list() {
  qDeleteAll(lists_);
  lists_.clear();
  const std::vector<LessonEntry>& entries = desk_.entries();
  for (std::size_t first = 0; first < entries.size(); first += lessons_a_menu) {
    const std::size_t end = std::min(first + lessons_a_menu, entries.size());
    auto* menu = new QMenu(tr("Lessons %1 to %2").arg(first + 1).arg(end), this);
    menu->setToolTipsVisible(true);
    for (std::size_t i = first; i < end; ++i) {
      const LessonEntry& entry = entries[i];
      QAction* action =
          menu->addAction(QStringLiteral("%1 %2").arg(i + 1).arg(QString(entry.title).replace('&', "&&")));
      action->setToolTip(entry.learn);
      action->setStatusTip(entry.learn);
      connect(action, &QAction::triggered, this, [this, file = entry.file] { emit lesson_wanted(file); });
    }
    insertMenu(behind_lessons_, menu);
    lists_.append(menu);
  }
}

}  // namespace feedscope::ui
