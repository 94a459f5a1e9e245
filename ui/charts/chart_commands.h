#pragma once

#include <QList>
#include <QMenu>
#include <QObject>
#include <array>
#include <optional>
#include <vector>

#include "ui/charts/chart_spec.h"
#include "ui/charts/csv_dialog.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

class ChartsPanel;

/// Commands of the charts: menu, keys and files. The plain keys work in the charts alone.
class ChartCommands : public QObject {
  Q_OBJECT

 public:
  /// Becomes a child of `panel`, whose charts must exist.
  explicit ChartCommands(ChartsPanel& panel);

  QList<QAction*> actions() const { return menu_->actions(); }
  QMenu& menu() { return *menu_; }

  /// Whether there are views before and after the shown one.
  void set_steps(bool back, bool forward);
  void set_second_cursor(bool there);
  void set_chart_shown(std::size_t chart, bool shown);
  void set_curve_shown(std::size_t chart, std::size_t curve, bool shown);
  void set_causes_shown(bool shown);

  /// Format by the file's ending, png or svg; throws InputError.
  void save_picture(const QString& file);
  /// Saves the visible range; `step` of CsvRows::samples [s]. Another thread writes it; exported() or
  /// failed() follows.
  void save_csv(const QString& file, CsvRows rows, double step = 0);

 signals:
  void exported(const QString& message);
  void failed(const QString& message);

 private:
  QAction* add_action(QMenu& menu, const QString& text, const QString& tip, const QKeySequence& key = {});
  void make_zoom_menu();
  void make_cursor_menu();
  void make_display_actions();
  void add_overlay_menu(std::size_t chart, QMenu& menu);
  void make_export_actions();
  void ask_for_csv();
  void ask_for_picture();

  ChartsPanel& panel_;
  QMenu* menu_;
  QAction* back_ = nullptr;
  QAction* forward_ = nullptr;
  QAction* remove_second_ = nullptr;
  QAction* show_causes_ = nullptr;
  std::array<QAction*, chart_count> chart_actions_{};
  std::array<std::vector<QAction*>, chart_count> curve_actions_;
  Job<QString> export_;
  QString export_file_;
};

}  // namespace feedscope::ui
