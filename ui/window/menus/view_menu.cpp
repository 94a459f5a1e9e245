#include "ui/window/menus/view_menu.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QLocale>
#include <QMainWindow>
#include <QSettings>

#include "ui/language/language.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/panel_action.h"
#include "ui/theme/theme.h"
#include "ui/window/dialogs/language_box.h"

namespace feedscope::ui {

namespace {

void use_theme(ThemeKind kind) {
  apply_theme(kind);
  QSettings().setValue("dark", kind == ThemeKind::dark);
}

}  // namespace

ViewMenu::ViewMenu(SideBySide& scenes, const ViewRange& range, const QList<QAction*>& presenting,
                   QMainWindow& window)
    : QMenu(tr("&View"), &window) {
  scenes.first().fill_menu(*this);
  QMenu* beside_each_other = addMenu(tr("&Side by side"));
  beside_each_other->addActions(scenes.panel_actions());
  connect(add(beside_each_other, tr("C&hart range only"), QKeySequence(tr("Ctrl+9")),
              tr("Zoom the 3D view to the time range of the charts")),
          &QAction::triggered, &scenes,
          [&scenes, &range] { scenes.first().zoom_to_times(range.lower_time(), range.upper_time()); });
  addSeparator();
  QMenu* docks = addMenu(tr("&Panels"));
  QMenu* beside = docks->addMenu(tr("&Beside the 3D view"));
  QMenu* below = docks->addMenu(tr("B&elow the 3D view"));
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    const bool is_below = window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
    (is_below ? below : beside)->addAction(dock->toggleViewAction());
  }
  docks->addSeparator();
  connect(add(docks, tr("&Default layout"), {}, tr("Original places and sizes of all panels")),
          &QAction::triggered, this, &ViewMenu::first_layout_wanted);
  addActions(presenting);
  QAction* dark =
      add(this, tr("&Dark"), QKeySequence(tr("Ctrl+Shift+D")), tr("Switch between light and dark colours"));
  dark->setCheckable(true);
  dark->setChecked(theme_of(QApplication::palette()) == ThemeKind::dark);
  connect(dark, &QAction::toggled, this, [](bool on) { use_theme(on ? ThemeKind::dark : ThemeKind::light); });
  add_languages();
  add_units();
}

QAction* ViewMenu::add(QMenu* menu, const QString& text, const QKeySequence& key, const QString& tip) {
  QAction* action = make_action(this, text, tip, key);
  menu->addAction(action);
  return action;
}

void ViewMenu::add_languages() {
  QMenu* menu = addMenu(tr("&Language"));
  auto* group = new QActionGroup(menu);
  for (const QString& code : languages()) {
    QAction* action = menu->addAction(own_name_of_language(code));
    action->setCheckable(true);
    action->setChecked(code == chosen_language());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, code] {
      if (code != chosen_language()) {
        choose_language(code);
        emit remake_wanted();
      }
    });
  }
}

void ViewMenu::add_units() {
  QMenu* menu = addMenu(tr("&Units"));
  auto* group = new QActionGroup(menu);
  const auto add = [&](const QString& text, const QString& tip, UnitSystem system) {
    QAction* action = menu->addAction(text);
    action->setToolTip(tip);
    action->setStatusTip(tip);
    action->setCheckable(true);
    action->setChecked(system == unit_system());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, system] {
      if (system != unit_system()) {
        choose_unit_system(system);
        emit remake_wanted();
      }
    });
  };
  add(tr("&Millimetres"), tr("Show numbers in mm, mm/min and m/s²"), UnitSystem::metric);
  add(tr("&Inches"), tr("Show numbers in inches; files keep their units"), UnitSystem::inch);
}

}  // namespace feedscope::ui
