#pragma once

#include <QMenu>

#include "ui/scene_view/side_by_side.h"

class QMainWindow;

namespace feedscope::ui {

/// How everything is shown: the 3D view, panels, colours, language and units.
class ViewMenu : public QMenu {
  Q_OBJECT

 public:
  /// All outlive this; the window has its docks by then.
  /// `presenting`: commands of the presentation.
  ViewMenu(SideBySide& scenes, const ViewRange& range, const QList<QAction*>& presenting,
           QMainWindow& window);

 signals:
  /// Panels are to be where they were at first.
  void first_layout_wanted();
  /// The language or the units have been chosen.
  void remake_wanted();

 private:
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& key, const QString& tip);
  void add_languages();
  void add_units();
};

}  // namespace feedscope::ui
