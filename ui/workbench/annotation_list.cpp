#include "ui/workbench/annotation_list.h"

#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace feedscope::ui {

class AnnotationList::Change : public QUndoCommand {
 public:
  /// `subject`: id of the annotation whose successive changes within one step merge; 0 for none.
  Change(AnnotationList& list, std::vector<Annotation> after, const QString& text, int subject)
      : QUndoCommand(text),
        list_(list),
        before_(list.items_),
        after_(std::move(after)),
        subject_(subject),
        step_(list.step_) {}

  void undo() override { list_.apply(before_); }
  void redo() override { list_.apply(after_); }
  int id() const override { return subject_ == 0 ? -1 : merging_changes; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const Change&>(*other);
    if (&next.list_ != &list_ || next.subject_ != subject_ || next.step_ != step_ || next.text() != text()) {
      return false;
    }
    after_ = next.after_;
    return true;
  }

 private:
  static constexpr int merging_changes = 1;  // no other command of the window merges

  AnnotationList& list_;
  std::vector<Annotation> before_;
  std::vector<Annotation> after_;
  int subject_;
  int step_;
};

AnnotationList::AnnotationList(QUndoStack& history, QObject* parent) : QObject(parent), history_(history) {}

const Annotation* AnnotationList::find(int id) const {
  const auto found = std::ranges::find(items_, id, &Annotation::id);
  return found == items_.end() ? nullptr : &*found;
}

void AnnotationList::select(int id) {
  if (id != selected_ && (id == 0 || find(id) != nullptr)) {
    selected_ = id;
    end_step();
    emit selection_changed();
  }
}

int AnnotationList::add(Annotation annotation) {
  annotation.id = next_id_++;
  std::vector<Annotation> after = items_;
  after.push_back(annotation);
  push(std::move(after), tr("add %1").arg(annotation_title(annotation.kind).toLower()), 0);
  select(annotation.id);
  return annotation.id;
}

void AnnotationList::remove(int id) {
  std::vector<Annotation> after = items_;
  if (std::erase_if(after, [id](const Annotation& item) { return item.id == id; }) > 0) {
    push(std::move(after), tr("remove annotation"), 0);
  }
}

void AnnotationList::change(const Annotation& changed, const QString& text) {
  std::vector<Annotation> after = items_;
  const auto found = std::ranges::find(after, changed.id, &Annotation::id);
  if (found != after.end() && !(*found == changed)) {
    *found = changed;
    push(std::move(after), text, changed.id);
  }
}

void AnnotationList::replace(std::vector<Annotation> items) {
  for (Annotation& item : items) {
    item.id = next_id_++;
  }
  apply(items);
}

void AnnotationList::push(std::vector<Annotation> after, const QString& text, int merge_key) {
  history_.push(new Change(*this, std::move(after), text, merge_key));
}

void AnnotationList::apply(const std::vector<Annotation>& items) {
  items_ = items;
  emit changed();
  if (selected_ != 0 && find(selected_) == nullptr) {
    select(0);
  }
}

}  // namespace feedscope::ui
