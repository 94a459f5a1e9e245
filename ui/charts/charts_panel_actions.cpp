// Commands of the charts: menus, keys and files.
#include <QAction>
#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QToolButton>
#include <QtConcurrentRun>

#include "ui/charts/chart_export.h"
#include "ui/charts/charts_panel.h"
#include "ui/models/panel_action.h"

namespace feedscope::ui {

namespace {

constexpr double zoom_a_key = 0.5;
constexpr int long_step = 10;          // [px]
constexpr double picture_scale = 2.0;  // pixels of a PNG to one on the screen

}  // namespace

QAction* ChartsPanel::add_action(const QString& text, const QString& tip, const QKeySequence& key) {
  QAction* action = make_action(this, text, tip, key);
  action->setShortcutContext(Qt::WidgetShortcut);  // plain keys mean something else in other panels
  for (KinematicChart* chart : charts_) {
    chart->addAction(action);
  }
  actions_.append(action);
  menu_->addAction(action);
  return action;
}

void ChartsPanel::make_actions() {
  make_zoom_actions();
  menu_->addSeparator();
  make_cursor_actions();
  menu_->addSeparator();
  make_display_actions();
  menu_->addSeparator();
  make_export_actions();
  more_->setText(QStringLiteral("☰"));
  more_->setToolTip(tr("Commands of the charts"));
  more_->setMenu(menu_);
  more_->setPopupMode(QToolButton::InstantPopup);
}

void ChartsPanel::make_zoom_actions() {
  QAction* all = add_action(tr("Show &all"), tr("Show the whole run, and all values; as a double click does"),
                            QKeySequence(tr("Ctrl+Shift+0")));
  all->setShortcutContext(Qt::WindowShortcut);
  connect(all, &QAction::triggered, this, &ChartsPanel::fit);
  show_all_->setDefaultAction(all);
  back_ = add_action(tr("&Back"), tr("The range and values shown before"), QKeySequence(tr("Alt+Left")));
  connect(back_, &QAction::triggered, this, [this] {
    rest();
    if (history_.can_go_back()) {
      show_view(history_.back());
    }
  });
  forward_ =
      add_action(tr("&Forward"), tr("The range and values shown after"), QKeySequence(tr("Alt+Right")));
  connect(forward_, &QAction::triggered, this, [this] {
    rest();
    if (history_.can_go_forward()) {
      show_view(history_.forward());
    }
  });
  back_->setEnabled(false);
  forward_->setEnabled(false);
  const auto zoom = [this](double factor) {
    const bool at_cursor = cursor_.valid() && range_.position_of(cursor_.state()) >= range_.lower() &&
                           range_.position_of(cursor_.state()) <= range_.upper();
    range_.zoom(factor,
                at_cursor ? range_.position_of(cursor_.state()) : (range_.lower() + range_.upper()) / 2);
  };
  connect(add_action(tr("Zoom &in"), tr("Half the range, around the cursor"), QKeySequence(Qt::Key_Plus)),
          &QAction::triggered, this, [zoom] { zoom(zoom_a_key); });
  connect(add_action(tr("Zoom &out"), tr("Twice the range, around the cursor"), QKeySequence(Qt::Key_Minus)),
          &QAction::triggered, this, [zoom] { zoom(1 / zoom_a_key); });
}

void ChartsPanel::make_cursor_actions() {
  const auto step = [this](const QString& text, const QString& tip, const QKeySequence& key, int pixels) {
    connect(add_action(text, tip, key), &QAction::triggered, this, [this, pixels] { move_cursor(pixels); });
  };
  step(tr("Cursor &left"), tr("Cursor one pixel to the left"), Qt::Key_Left, -1);
  step(tr("Cursor &right"), tr("Cursor one pixel to the right"), Qt::Key_Right, 1);
  step(tr("Cursor far left"), tr("Cursor ten pixels to the left"), QKeySequence(tr("Shift+Left")),
       -long_step);
  step(tr("Cursor far right"), tr("Cursor ten pixels to the right"), QKeySequence(tr("Shift+Right")),
       long_step);
  connect(add_action(tr("Set cursor &B"), tr("Second cursor where the cursor is; differences between both"),
                     QKeySequence(Qt::Key_B)),
          &QAction::triggered, this, [this] { set_second_cursor(cursor_.state().time); });
  remove_second_ = add_action(tr("Remove c&ursor B"), tr("No second cursor (Esc)"));
  remove_second_->setEnabled(false);
  connect(remove_second_, &QAction::triggered, this, [this] { set_second_cursor({}); });
  connect(add_action(tr("&Zoom to A–B"), tr("The range between both cursors"), QKeySequence(Qt::Key_Z)),
          &QAction::triggered, this, &ChartsPanel::zoom_to_cursors);
}

void ChartsPanel::make_display_actions() {
  connect(
      add_action(tr("Over time or &path length"), tr("What runs along the charts"), QKeySequence(Qt::Key_T)),
      &QAction::triggered, this, [this] {
        choose_abscissa(range_.abscissa() == Abscissa::time ? Abscissa::path_length : Abscissa::time);
      });
  show_causes_ = add_action(tr("Limiting &causes"), tr("What limits the feed, below the feed"));
  show_causes_->setCheckable(true);
  show_causes_->setChecked(true);
  connect(show_causes_, &QAction::toggled, causes_, &QWidget::setVisible);
  auto* curves = new QMenu(tr("Cur&ves"), menu_);
  auto* others = new QMenu(tr("Curves of &other runs"), menu_);
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    const ChartSpec& spec = charts_[i]->spec();
    for (std::size_t k = 0; k < spec.curves.size(); ++k) {
      QAction* action = curves->addAction(tr("%1, %2").arg(spec.title, spec.curves[k].name));
      action->setToolTip(tr("Show or hide the curve [%1]").arg(spec.unit));
      action->setCheckable(true);
      action->setChecked(true);
      connect(action, &QAction::toggled, this, [this, i, k](bool on) {
        if (on != charts_[i]->curve_shown(k)) {
          show_curve(i, k, on);
        }
      });
      curve_actions_[i].push_back(action);
    }
    curves->addSeparator();
    add_overlay_menu(i, *others);
  }
  for (QMenu* menu : {curves, others}) {
    menu_->addMenu(menu);
    actions_.append(menu->menuAction());
  }
}

void ChartsPanel::add_overlay_menu(std::size_t chart, QMenu& menu) {
  const ChartSpec& spec = charts_[chart]->spec();
  QMenu* choice = menu.addMenu(spec.title);
  auto* group = new QActionGroup(choice);
  const auto add = [&](const QString& text, std::optional<std::size_t> curve) {
    QAction* action = group->addAction(choice->addAction(text));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, chart, curve] { set_overlay_curve(chart, curve); });
    connect(choice, &QMenu::aboutToShow, action,
            [this, action, chart, curve] { action->setChecked(overlay_curve_[chart] == curve); });
  };
  add(tr("none"), {});
  for (std::size_t k = 0; k < spec.curves.size(); ++k) {
    add(spec.curves[k].name, k);
  }
}

void ChartsPanel::make_export_actions() {
  connect(add_action(tr("Export visible range as C&SV …"), tr("Values of the visible range as a table")),
          &QAction::triggered, this, &ChartsPanel::ask_for_csv);
  connect(add_action(tr("Export pict&ure …"), tr("The charts as they are, as PNG or SVG")),
          &QAction::triggered, this, &ChartsPanel::ask_for_picture);
  connect(&export_, &QFutureWatcher<QString>::finished, this, [this] {
    const QString error = export_.result();
    if (error.isEmpty()) {
      emit exported(tr("%1 has been written").arg(QFileInfo(export_file_).fileName()));
    } else {
      emit failed(error);
    }
  });
}

void ChartsPanel::show_menu(const QPoint& global) {
  menu_->popup(global);
}

void ChartsPanel::ask_for_csv() {
  if (trajectory_ == nullptr) {
    emit failed(tr("No run to export yet."));
    return;
  }
  refresh();
  const Interval range = view().time;
  CsvDialog dialog(range, sample_time_, block_times(*trajectory_, range).size(), columns_.times().size(),
                   this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, tr("Export visible range"),
                                                    QStringLiteral("charts.csv"), tr("Tables (*.csv)"));
  if (!file.isEmpty()) {
    save_csv(file, dialog.rows(), dialog.step());
  }
}

void ChartsPanel::ask_for_picture() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export picture"), QStringLiteral("charts.png"),
                                                    tr("Picture (*.png);;Drawing (*.svg)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    save_picture(file);
    emit exported(tr("%1 has been written").arg(QFileInfo(file).fileName()));
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
  }
}

void ChartsPanel::save_picture(const QString& file) {
  refresh();
  const auto drawing = [this](QPainter& painter) { draw(painter); };
  if (file.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive)) {
    save_svg(file, size(), tr("Feed, acceleration and jerk"), drawing);
  } else {
    save_png(file, size(), picture_scale, drawing);
  }
}

void ChartsPanel::save_csv(const QString& file, CsvRows rows, double step) {
  if (trajectory_ == nullptr) {
    emit failed(tr("No run to export yet."));
    return;
  }
  if (export_.isRunning()) {
    emit failed(tr("%1 is still being written.").arg(export_file_));
    return;
  }
  refresh();
  const Interval range = view().time;
  const std::vector<double> columns = columns_.times();
  export_file_ = file;
  export_.setFuture(
      QtConcurrent::run([file, rows, range, columns, step, trajectory = trajectory_]() -> QString {
        try {
          feedscope::ui::save_csv(file, *trajectory,
                                  rows == CsvRows::samples  ? sample_times(range, step)
                                  : rows == CsvRows::blocks ? block_times(*trajectory, range)
                                                            : columns);
          return {};
        } catch (const std::exception& error) {
          return QString::fromUtf8(error.what());
        }
      }));
}

void ChartsPanel::show_all_curves() {
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    for (std::size_t k = 0; k < charts_[i]->spec().curves.size(); ++k) {
      show_curve(i, k, true);
    }
  }
}

}  // namespace feedscope::ui
