#include "ui/charts/chart_commands.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "ui/charts/chart_export.h"
#include "ui/charts/charts_panel.h"
#include "ui/language/in_language.h"
#include "ui/shared/panel_action.h"

namespace feedscope::ui {

namespace {

constexpr double zoom_a_key = 0.5;
constexpr int long_step = 10;  // [px]

}  // namespace

ChartCommands::ChartCommands(ChartsPanel& panel) : QObject(&panel), panel_(panel), menu_(new QMenu(&panel)) {
  QAction* all = add_action(*menu_, tr("Show &all"), tr("Show the whole run and all values (double click)"),
                            QKeySequence(tr("Ctrl+Shift+0")));
  all->setShortcutContext(Qt::WindowShortcut);
  connect(all, &QAction::triggered, &panel_, &ChartsPanel::fit);
  make_zoom_menu();
  make_cursor_menu();
  menu_->addSeparator();
  make_display_actions();
  menu_->addSeparator();
  make_export_actions();
}

QAction* ChartCommands::add_action(QMenu& menu, const QString& text, const QString& tip,
                                   const QKeySequence& key) {
  QAction* action = make_action(this, text, tip, key);
  action->setShortcutContext(Qt::WidgetShortcut);  // plain keys have other meanings in other panels
  for (std::size_t i = 0; i < chart_count; ++i) {
    panel_.chart(i).addAction(action);
  }
  menu.addAction(action);
  return action;
}

void ChartCommands::set_steps(bool back, bool forward) {
  back_->setEnabled(back);
  forward_->setEnabled(forward);
}

void ChartCommands::set_second_cursor(bool there) {
  remove_second_->setEnabled(there);
}

void ChartCommands::set_curve_shown(std::size_t chart, std::size_t curve, bool shown) {
  curve_actions_[chart][curve]->setChecked(shown);
}

void ChartCommands::set_chart_shown(std::size_t chart, bool shown) {
  chart_actions_[chart]->setChecked(shown);
}

void ChartCommands::set_causes_shown(bool shown) {
  show_causes_->setChecked(shown);
}

void ChartCommands::make_zoom_menu() {
  QMenu& menu = *menu_->addMenu(tr("&Zoom"));
  back_ = add_action(menu, tr("&Back"), tr("Show the previous range and values"),
                     QKeySequence(tr("Ctrl+Alt+Left")));
  connect(back_, &QAction::triggered, &panel_, &ChartsPanel::go_back);
  forward_ = add_action(menu, tr("&Forward"), tr("Show the next range and values"),
                        QKeySequence(tr("Ctrl+Alt+Right")));
  connect(forward_, &QAction::triggered, &panel_, &ChartsPanel::go_forward);
  back_->setEnabled(false);
  forward_->setEnabled(false);
  const auto zoom = [this](double factor) { panel_.zoom(factor); };
  connect(add_action(menu, tr("Zoom &in"), tr("Zoom in around the cursor"), QKeySequence(Qt::Key_Plus)),
          &QAction::triggered, this, [zoom] { zoom(zoom_a_key); });
  connect(add_action(menu, tr("Zoom &out"), tr("Zoom out around the cursor"), QKeySequence(Qt::Key_Minus)),
          &QAction::triggered, this, [zoom] { zoom(1 / zoom_a_key); });
}

void ChartCommands::make_cursor_menu() {
  QMenu& menu = *menu_->addMenu(tr("&Cursor"));
  const auto step = [this, &menu](const QString& text, const QString& tip, const QKeySequence& key,
                                  int pixels) {
    connect(add_action(menu, text, tip, key), &QAction::triggered, this,
            [this, pixels] { panel_.move_cursor(pixels); });
  };
  step(tr("Cursor &left"), tr("Move the cursor one pixel to the left"), Qt::Key_Left, -1);
  step(tr("Cursor &right"), tr("Move the cursor one pixel to the right"), Qt::Key_Right, 1);
  step(tr("Cursor far left"), tr("Move the cursor ten pixels to the left"), QKeySequence(tr("Shift+Left")),
       -long_step);
  step(tr("Cursor far right"), tr("Move the cursor ten pixels to the right"), QKeySequence(tr("Shift+Right")),
       long_step);
  connect(
      add_action(menu, tr("Set cursor &B"), tr("Set a second cursor at the cursor and show the differences"),
                 QKeySequence(Qt::Key_B)),
      &QAction::triggered, this, [this] { panel_.set_second_cursor(panel_.cursor().state().time); });
  remove_second_ = add_action(menu, tr("Remove c&ursor B"), tr("Remove the second cursor (Esc)"));
  remove_second_->setEnabled(false);
  connect(remove_second_, &QAction::triggered, this, [this] { panel_.set_second_cursor({}); });
  connect(add_action(menu, tr("&Zoom to A–B"), tr("Zoom to the range between the cursors"),
                     QKeySequence(Qt::Key_Z)),
          &QAction::triggered, &panel_, &ChartsPanel::zoom_to_cursors);
}

void ChartCommands::make_display_actions() {
  connect(add_action(*menu_, tr("Over time or &path length"), tr("Horizontal axis of the charts"),
                     QKeySequence(Qt::Key_T)),
          &QAction::triggered, this, [this] {
            panel_.choose_abscissa(panel_.range().abscissa() == Abscissa::time ? Abscissa::path_length
                                                                               : Abscissa::time);
          });
  show_causes_ = add_action(*menu_, tr("Limiting &causes"), tr("Show the limiting causes below the feed"));
  show_causes_->setCheckable(true);
  show_causes_->setChecked(true);
  connect(show_causes_, &QAction::toggled, &panel_.causes(), &QWidget::setVisible);
  QAction* rapids = add_action(*menu_, tr("&Rapids"), tr("Show rapids here and in the 3D view"));
  rapids->setCheckable(true);
  rapids->setChecked(panel_.range().rapids_shown());
  connect(rapids, &QAction::triggered, &panel_.range(), &ViewRange::show_rapids);
  connect(&panel_.range(), &ViewRange::rapids_shown_changed, rapids, &QAction::setChecked);
  auto* charts = new QMenu(tr("C&harts shown"), menu_);
  auto* curves = new QMenu(tr("Cur&ves"), menu_);
  auto* others = new QMenu(tr("Curves of &other runs"), menu_);
  for (std::size_t i = 0; i < chart_count; ++i) {
    const ChartSpec& spec = panel_.chart(i).spec();
    chart_actions_[i] = charts->addAction(spec.title);
    chart_actions_[i]->setToolTip(tr("Show or hide the chart, where the run has its values"));
    chart_actions_[i]->setCheckable(true);
    chart_actions_[i]->setChecked(!spec.on_demand);
    connect(chart_actions_[i], &QAction::triggered, this, [this, i](bool on) { panel_.show_chart(i, on); });
    QMenu* of_chart = curves->addMenu(spec.title);
    for (std::size_t k = 0; k < spec.curves.size(); ++k) {
      QAction* action = of_chart->addAction(spec.curves[k].name);
      action->setToolTip(tr("Show or hide the curve [%1]").arg(spec.unit));
      action->setCheckable(true);
      action->setChecked(!spec.curves[k].on_demand);
      connect(action, &QAction::toggled, this, [this, i, k](bool on) {
        if (on != panel_.chart(i).curve_shown(k)) {
          panel_.show_curve(i, k, on);
        }
      });
      curve_actions_[i].push_back(action);
    }
    add_overlay_menu(i, *others);
  }
  for (QMenu* menu : {charts, curves, others}) {
    menu_->addMenu(menu);
  }
}

void ChartCommands::add_overlay_menu(std::size_t chart, QMenu& menu) {
  const ChartSpec& spec = panel_.chart(chart).spec();
  QMenu* choice = menu.addMenu(spec.title);
  auto* group = new QActionGroup(choice);
  const auto add = [&](const QString& text, std::optional<std::size_t> curve) {
    QAction* action = group->addAction(choice->addAction(text));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, chart, curve] { panel_.set_overlay_curve(chart, curve); });
    connect(choice, &QMenu::aboutToShow, action,
            [this, action, chart, curve] { action->setChecked(panel_.overlay_curve(chart) == curve); });
  };
  add(tr("none"), {});
  for (std::size_t k = 0; k < spec.curves.size(); ++k) {
    add(spec.curves[k].name, k);
  }
}

void ChartCommands::make_export_actions() {
  connect(add_action(*menu_, tr("Export visible range as C&SV …"),
                     tr("Export the values of the visible range as a table")),
          &QAction::triggered, this, &ChartCommands::ask_for_csv);
  connect(add_action(*menu_, tr("Export pict&ure …"), tr("Export the charts as shown, as PNG or SVG")),
          &QAction::triggered, this, &ChartCommands::ask_for_picture);
}

void ChartCommands::ask_for_csv() {
  if (panel_.trajectory() == nullptr) {
    emit failed(tr("No run to export yet."));
    return;
  }
  panel_.refresh();
  const Interval range = panel_.shown_times();
  CsvDialog dialog(range, panel_.sample_time(), block_times(*panel_.trajectory(), range).size(),
                   panel_.column_times().size(), &panel_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const QString file = QFileDialog::getSaveFileName(&panel_, tr("Export visible range"),
                                                    QStringLiteral("charts.csv"), tr("Tables (*.csv)"));
  if (!file.isEmpty()) {
    save_csv(file, dialog.rows(), dialog.step());
  }
}

void ChartCommands::ask_for_picture() {
  const QString file = QFileDialog::getSaveFileName(
      &panel_, tr("Export picture"), QStringLiteral("charts.png"), tr("Picture (*.png);;Drawing (*.svg)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    save_picture(file);
    emit exported(tr("%1 has been written").arg(QFileInfo(file).fileName()));
  } catch (const std::exception& error) {
    emit failed(failure_text(error));
  }
}

void ChartCommands::save_picture(const QString& file) {
  panel_.refresh();
  feedscope::ui::save_picture(file, panel_.size(), tr("Feed, acceleration and jerk"),
                              [this](QPainter& painter) { panel_.draw(painter); });
}

void ChartCommands::save_csv(const QString& file, CsvRows rows, double step) {
  if (panel_.trajectory() == nullptr) {
    emit failed(tr("No run to export yet."));
    return;
  }
  if (export_.busy()) {
    emit failed(tr("%1 is still being written.").arg(export_file_));
    return;
  }
  panel_.refresh();
  const Interval range = panel_.shown_times();
  export_file_ = file;
  export_.start(
      [file, rows, range, columns = panel_.column_times(), step, trajectory = panel_.trajectory(),
       sources = panel_.sources()](JobControl&) {
        feedscope::ui::save_csv(file, *trajectory,
                                rows == CsvRows::samples  ? sample_times(range, step)
                                : rows == CsvRows::blocks ? block_times(*trajectory, range)
                                                          : columns,
                                sources);
        return file;
      },
      [this](const JobOutcome<QString>& outcome) {
        if (outcome.result) {
          emit exported(tr("%1 has been written").arg(QFileInfo(*outcome.result).fileName()));
        } else if (!outcome.cancelled()) {
          emit failed(outcome.failure);
        }
      });
}

}  // namespace feedscope::ui
