#pragma once

#include <QList>
#include <memory>

#include "ui/program_text/program_view.h"
#include "ui/workbench/panel.h"

class QAction;
class QLabel;

namespace feedscope::ui {

class FindBar;
class GoToBar;

/// A program's text with the bars that search it and go to a line, their commands, and the extents of its
/// path.
class ProgramPanel : public Panel {
  Q_OBJECT

 public:
  explicit ProgramPanel(QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// Null: no program.
  void set_program(std::shared_ptr<const Program> program);
  ProgramView& view() { return *view_; }
  FindBar& find_bar() { return *find_bar_; }
  GoToBar& go_to_bar() { return *go_to_bar_; }
  QList<QAction*> panel_actions() const override { return actions_; }

  /// Goes to the place of a diagnostic; `column` is a 1-based byte, 0: the line as a whole.
  void go_to(std::uint32_t line, std::uint32_t column);

 protected:
  /// Hides the extents if the panel is only a few lines high.
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_extents();
  template <typename Slot>
  QAction* add_action(const QString& text, const QString& tip, const QKeySequence& key, Slot slot);
  void add_actions();
  void show_extents(const Program* program);

  ProgramView* view_;
  FindBar* find_bar_;
  GoToBar* go_to_bar_;
  bool has_extents_ = false;
  QLabel* extents_;  ///< of the feed motions; hidden without any
  QList<QAction*> actions_;
};

}  // namespace feedscope::ui
