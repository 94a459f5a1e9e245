#pragma once

#include <QFrame>

#include "ui/window/menus/action_table.h"

class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace feedscope::ui {

/// Finds a command by some of its words and runs it: type, arrow keys, Enter.
class CommandPalette : public QFrame {
  Q_OBJECT

 public:
  explicit CommandPalette(QWidget* window);

  /// Opens over the centre of the window with `actions` to choose from.
  void ask(QList<ListedAction> actions);
  QLineEdit* input() { return input_; }
  QTableView* list() { return list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter(const QString& words);
  void run();

  ActionTable* actions_;
  QSortFilterProxyModel* found_;
  QLineEdit* input_;
  QTableView* list_;
};

/// The commands with keys, and the mouse gestures, in a separate window; Esc closes it.
class KeyList : public QWidget {
  Q_OBJECT

 public:
  explicit KeyList(QWidget* window);
  /// Opens over the centre of the window.
  void show_keys(QList<ListedAction> actions);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ActionTable* actions_;
  QTableView* list_;
};

}  // namespace feedscope::ui
