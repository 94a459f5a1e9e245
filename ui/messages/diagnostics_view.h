#pragma once

#include <cstdint>

#include "ui/messages/diagnostics_model.h"
#include "ui/workbench/panel.h"

class QAction;
class QComboBox;
class QTreeView;

namespace feedscope::ui {

/// The diagnostics of a program and messages of the application, filtered by severity. Choosing a row goes to
/// its place.
class DiagnosticsView : public Panel {
  Q_OBJECT

 public:
  explicit DiagnosticsView(QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  void set_program(std::shared_ptr<const Program> program) { model_->set_program(std::move(program)); }
  void add_message(Severity severity, const QString& message) { model_->add_message(severity, message); }
  /// Start of the search for the next and previous message.
  void set_place(TextPlace place) { place_ = place; }

  const DiagnosticsModel& model() const { return *model_; }
  QTreeView& list() { return *list_; }
  QComboBox& filter() { return *filter_; }
  QList<QAction*> panel_actions() const override { return actions_; }

 signals:
  /// `column` is a 1-based byte; 0: the line as a whole.
  void place_chosen(std::uint32_t line, std::uint32_t column);

 private:
  void add_step(const QString& text, const QString& tip, const QKeySequence& key, bool forward);
  void step(bool forward);
  void choose(const QModelIndex& index);

  DiagnosticsModel* model_;
  DiagnosticsFilter* shown_;
  QTreeView* list_;
  QComboBox* filter_;
  QList<QAction*> actions_;
  TextPlace place_;
};

}  // namespace feedscope::ui
