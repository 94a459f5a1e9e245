#include "ui/window/menus/help_menu.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>

#include "ui/help/handbook_window.h"
#include "ui/shared/panel_action.h"
#include "ui/workbench/panel.h"

namespace feedscope::ui {

namespace {

void collect(const QMenu& menu, const QString& place, QList<ListedAction>& list) {
  for (QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      collect(*action->menu(), QStringLiteral("%1 › %2").arg(place, plain_text(action->text())), list);
    } else if (!action->isSeparator() && !action->text().isEmpty()) {
      list.append({place, action});
    }
  }
}

}  // namespace

HelpMenu::HelpMenu(Panel& lessons, QMainWindow& window)
    : QMenu(tr("&Help"), &window),
      window_(window),
      handbook_(new HandbookWindow(&window)),
      palette_(new CommandPalette(&window)),
      key_list_(new KeyList(&window)) {
  QAction* handbook = add(tr("Hand&book"), QKeySequence::HelpContents, tr("First steps, panels, commands"));
  set_everyday_words(handbook, tr("help manual documentation how to"));
  connect(handbook, &QAction::triggered, this, [this] { handbook_->show_page(QStringLiteral("index")); });
  connect(add(tr("&Start page"), {}, tr("Samples, recent programs, lessons, what to do first")),
          &QAction::triggered, this, &HelpMenu::start_page_wanted);
  connect(add(tr("&Lessons"), {}, tr("Lessons for courses, with questions on the simulation")),
          &QAction::triggered, &lessons, &Panel::attention_wanted);
  addSeparator();
  connect(add(tr("&Find a command …"), QKeySequence(tr("Ctrl+K")),
              tr("Find a command by typing part of its name")),
          &QAction::triggered, this, [this] { palette_->ask(commands()); });
  connect(add(tr("&Keyboard and mouse"), QKeySequence(tr("Ctrl+F1")),
              tr("All keyboard shortcuts and mouse actions")),
          &QAction::triggered, this, [this] { key_list_->show_keys(commands()); });
  addSeparator();
  connect(add(tr("&About Feedscope"), {}, tr("Version and licence")), &QAction::triggered, this,
          &HelpMenu::show_about);
}

void HelpMenu::show_first_steps() {
  handbook_->show_page(QStringLiteral("first-steps"));
}

void HelpMenu::show_about() {
  QMessageBox about(
      QMessageBox::NoIcon, tr("About Feedscope"),
      tr("<h3>Feedscope %1</h3><p>Shows what a CNC control does with an NC program: path, feed, "
         "acceleration and jerk, and what limits the feed.</p><p>Models of published controls on "
         "published machines. How far to trust a number: <i>Help › Handbook</i>, <i>Models and "
         "accuracy</i>.</p><p>The source is BSD 3-clause. With Qt %2 (LGPL 3), "
         "VTK and the DejaVu fonts.</p>")
          .arg(QStringLiteral(FEEDSCOPE_VERSION), QString::fromLatin1(qVersion())),
      QMessageBox::Close, &window_);
  about.setIconPixmap(QApplication::windowIcon().pixmap(64));
  about.exec();
}

QAction* HelpMenu::add(const QString& text, const QKeySequence& key, const QString& tip) {
  QAction* action = make_action(this, text, tip, key);
  addAction(action);
  return action;
}

QList<ListedAction> HelpMenu::commands() const {
  QList<ListedAction> list;
  for (const QAction* menu : window_.menuBar()->actions()) {
    collect(*menu->menu(), plain_text(menu->text()), list);
  }
  return list;
}

}  // namespace feedscope::ui
