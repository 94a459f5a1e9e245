#pragma once

#include <QMenu>

#include "ui/window/menus/command_palette.h"

class QMainWindow;

namespace feedscope::ui {

class HandbookWindow;
class Panel;

/// Handbook, lessons, and all commands by name and key.
class HelpMenu : public QMenu {
  Q_OBJECT

 public:
  /// Both outlive this.
  HelpMenu(Panel& lessons, QMainWindow& window);

  /// All commands of the menus, in order.
  QList<ListedAction> commands() const;
  void show_first_steps();

 signals:
  void start_page_wanted();

 private:
  void show_about();
  QAction* add(const QString& text, const QKeySequence& key, const QString& tip);

  QMainWindow& window_;
  HandbookWindow* handbook_;
  CommandPalette* palette_;
  KeyList* key_list_;
};

}  // namespace feedscope::ui
