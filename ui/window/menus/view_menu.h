#pragma once

#include <QMenu>

#include "ui/scene_view/side_by_side.h"

class QMainWindow;

namespace feedscope::ui {

/// Commands on the display: the 3D view, panels, colours, language and units.
class ViewMenu : public QMenu {
  Q_OBJECT

 public:
  /// All outlive this; the window must have its docks.
  /// `presenting`: commands of the presentation.
  ViewMenu(SideBySide& scenes, const ViewRange& range, const QList<QAction*>& presenting,
           QMainWindow& window);

 signals:
  /// Requests the initial layout of the panels.
  void first_layout_wanted();
  /// The user has chosen a language or units.
  void remake_wanted();

 private:
  QAction* add(QMenu* menu, const QString& text, const QKeySequence& key, const QString& tip);
  void add_languages();
  void add_units();
};

}  // namespace feedscope::ui
