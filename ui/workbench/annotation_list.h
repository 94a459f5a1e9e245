#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "ui/workbench/annotation.h"

namespace feedscope::ui {

/// The annotations of a program, and which of them is selected. Every change can be undone.
class AnnotationList : public QObject {
  Q_OBJECT

 public:
  /// `history` outlives this; the changes of runs may stand in it too.
  explicit AnnotationList(QUndoStack& history, QObject* parent = nullptr);

  const std::vector<Annotation>& items() const { return items_; }
  /// Null if it is gone.
  const Annotation* find(int id) const;
  /// Id of the selected one; 0 if none is.
  int selected() const { return selected_; }
  void select(int id);

  /// Gives it an id and selects it.
  int add(Annotation annotation);
  void remove(int id);
  /// Puts `changed` in the place of the one with its id. `text` names the change in the history, where
  /// changes of one name to one annotation are one step until end_step().
  void change(const Annotation& changed, const QString& text);
  /// The next change is a step of its own: the mouse has been released, the focus has gone.
  void end_step() { ++step_; }
  /// Other annotations altogether, their ids given again; not part of the history.
  void replace(std::vector<Annotation> items);

 signals:
  /// Annotations have come, gone or changed.
  void changed();
  void selection_changed();

 private:
  class Change;

  void push(std::vector<Annotation> after, const QString& text, int merge_key);
  void apply(const std::vector<Annotation>& items);

  QUndoStack& history_;
  std::vector<Annotation> items_;
  int next_id_ = 1;
  int selected_ = 0;
  int step_ = 0;
};

}  // namespace feedscope::ui
