#pragma once

#include <QList>
#include <QWidget>
#include <optional>

#include "ui/charts/contour_chart.h"
#include "ui/models/contour_job.h"
#include "ui/models/contour_places_model.h"
#include "ui/models/workbench.h"

class QAction;
class QCheckBox;
class QLabel;
class QSplitter;
class QTreeView;

namespace feedscope::ui {

/// How far the executed path of the current run is from the programmed one: in a sentence, as a histogram
/// beside those of the other visible runs, and the worst places to go to. Found only while it is seen.
class ContourView : public QWidget {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit ContourView(Workbench& model, QWidget* parent = nullptr);

  /// Whether the panel that holds this is in front.
  void set_on_screen(bool on_screen);
  /// Wanted reports are still to come.
  bool busy() const { return job_.busy(); }
  QString verdict() const;
  ContourPlacesModel& places() { return *places_; }
  ContourChart& chart() { return *chart_; }
  QTreeView& list() { return *list_; }
  QCheckBox& sides() { return *sides_; }
  QList<QAction*> panel_actions() const { return actions_; }
  /// To the next and to the previous place.
  QList<QAction*> step_actions() const { return steps_; }

 signals:
  void attention_wanted();
  /// `time` of the place; between `from` and `to` lies the path that a close-up shows [s].
  void place_chosen(double time, double from, double to, bool close_up);
  void failed(const QString& message);

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

  Workbench& model_;
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
  std::weak_ptr<const Program> judged_;  ///< whose deviation has said whether sides are shown
  std::optional<bool> pending_step_;     ///< once the places are there: forward or back
};

}  // namespace feedscope::ui
