#pragma once

#include <QList>
#include <optional>

#include "ui/contour/contour_chart.h"
#include "ui/contour/contour_job.h"
#include "ui/contour/contour_places_model.h"
#include "ui/workbench/panel.h"
#include "ui/workbench/workbench.h"

class QAction;
class QCheckBox;
class QLabel;
class QSplitter;
class QTreeView;

namespace feedscope::ui {

/// Distance of the current run's executed path from the programmed one: a sentence, a histogram with those of
/// the other visible runs, and a list of the worst places. Computed only while it is visible.
class ContourView : public Panel {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit ContourView(Workbench& workbench, QWidget* parent = nullptr);

  /// Whether the panel that contains this is in front.
  void set_on_screen(bool on_screen) override;
  /// Whether requested reports are still pending.
  bool busy() const override { return job_.busy(); }
  QString verdict() const;
  ContourPlacesModel& places() { return *places_; }
  ContourChart& chart() { return *chart_; }
  QTreeView& list() { return *list_; }
  QCheckBox& sides() { return *sides_; }
  QList<QAction*> panel_actions() const override { return actions_; }
  /// Actions that go to the next and to the previous place.
  QList<QAction*> step_actions() const { return steps_; }

 signals:
  /// The user has chosen a row: `time` of the place, which is between `from` and `to` [s].
  void place_chosen(double time, double from, double to);
  /// Requests that the path between these times fills the 3D view [s].
  void close_up_wanted(double from, double to);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool is_seen() const { return on_screen_ && isVisible(); }
  void make_actions();
  void make_layout();
  void refresh();
  void show_reports();
  ContourCurves curves() const;
  void step(bool forward);
  void choose(const QModelIndex& index);
  void save(const QString& title, const std::string& text);
  std::string histogram_csv() const;

  Workbench& workbench_;
  ContourJob job_;
  ContourPlacesModel* places_;
  QLabel* verdict_;
  QLabel* shares_;
  QCheckBox* sides_;
  QCheckBox* close_up_;
  QSplitter* results_;
  ContourChart* chart_;
  QTreeView* list_;
  QList<QAction*> actions_;
  QList<QAction*> steps_;
  bool on_screen_ = true;
  std::weak_ptr<const Program> judged_;  ///< program whose deviation decided whether sides are shown
  std::optional<bool> pending_step_;     ///< as soon as the places are known: forward or back
};

}  // namespace feedscope::ui
