#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "ui/workbench/annotation.h"

namespace feedscope::ui {

/// The annotations of a program and the selected one. Every change can be undone.
class AnnotationList : public QObject {
  Q_OBJECT

 public:
  /// `history` outlives this; it may also contain the changes of runs.
  explicit AnnotationList(QUndoStack& history, QObject* parent = nullptr);

  const std::vector<Annotation>& items() const { return items_; }
  /// Null if it no longer exists.
  const Annotation* find(int id) const;
  /// Id of the selected one; 0 for none.
  int selected() const { return selected_; }
  void select(int id);

  /// Assigns an id and selects the annotation.
  int add(Annotation annotation);
  void remove(int id);
  /// Replaces the annotation with the id of `changed`. `text` names the change in the history, where equally
  /// named changes of one annotation are one step until end_step().
  void change(const Annotation& changed, const QString& text);
  /// The next change is a separate step: the mouse has been released, or the focus has moved.
  void end_step() { ++step_; }
  /// Replaces all annotations and assigns new ids; not part of the history.
  void replace(std::vector<Annotation> items);

 signals:
  /// Annotations were added, removed or changed.
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
