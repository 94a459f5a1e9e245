#pragma once

#include "ui/slow_places/slow_places_model.h"
#include "ui/workbench/panel.h"

class QAction;
class QComboBox;
class QLabel;
class QTreeView;

namespace feedscope::ui {

/// Places where a run loses time against its programmed feed, the worst first. Choosing a place, or stepping
/// to the next one in program order, goes there.
class SlowPlacesView : public Panel {
  Q_OBJECT

 public:
  explicit SlowPlacesView(QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// Null: none.
  void set_places(std::shared_ptr<const SlowPlaces> places);
  /// Time of the run's cursor [s], from which the next and the previous place are searched.
  void set_time(double time) { time_ = time; }

  SlowPlacesModel& model() { return *model_; }
  QTreeView& list() { return *list_; }
  QComboBox& most() { return *most_; }
  QString summary() const;
  QList<QAction*> panel_actions() const override { return actions_; }

 signals:
  /// `slowest` is between `from` and `to` [s].
  void place_chosen(double slowest, double from, double to);

 private:
  void add_step(const QString& text, const QString& tip, const QKeySequence& key, bool forward);
  void step(bool forward);
  void choose(const QModelIndex& index);
  void say_sum();

  SlowPlacesModel* model_;
  QTreeView* list_;
  QComboBox* most_;
  QLabel* sum_;
  QList<QAction*> actions_;
  double time_ = 0;
};

}  // namespace feedscope::ui
