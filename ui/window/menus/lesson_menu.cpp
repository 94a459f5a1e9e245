#include "ui/window/menus/lesson_menu.h"

namespace feedscope::ui {

LessonMenu::LessonMenu(LessonDesk& desk, const QList<QAction*>& commands, const QList<QAction*>& handouts,
                       QAction* unlock, QWidget* parent)
    : QMenu(tr("&Lessons"), parent), desk_(desk), behind_lessons_(addSeparator()) {
  addMenu(tr("&This lesson"))->addActions(commands);
  addMenu(tr("&Hand-outs"))->addActions(handouts);
  addAction(unlock);
  connect(&desk_, &LessonDesk::listed, this, &LessonMenu::list);
  list();
  desk_.list();
}

void LessonMenu::list() {
  qDeleteAll(lists_);
  lists_.clear();
  const std::vector<LessonEntry>& entries = desk_.entries();
  for (const bool half_day : {true, false}) {
    auto* menu = new QMenu(half_day ? tr("Half a &day") : tr("T&wo days"), this);
    menu->setToolTipsVisible(true);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const LessonEntry& entry = entries[i];
      if (half_day && !entry.half_day) {
        continue;
      }
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
