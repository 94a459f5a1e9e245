#pragma once

#include <QMenu>
#include <filesystem>

#include "ui/lessons/lesson_desk.h"

namespace feedscope::ui {

/// The lessons of each of the two courses in order, then the commands of the open lesson.
class LessonMenu : public QMenu {
  Q_OBJECT

 public:
  /// `desk` outlives this. `commands`: of the open lesson; `handouts`: its hand-outs; `unlock`: for all
  /// lessons.
  LessonMenu(LessonDesk& desk, const QList<QAction*>& commands, const QList<QAction*>& handouts,
             QAction* unlock, QWidget* parent);

 signals:
  void lesson_wanted(const std::filesystem::path& file);

 private:
  void list();

  LessonDesk& desk_;
  QAction* behind_lessons_;
  QList<QMenu*> lists_;
};

}  // namespace feedscope::ui
