#include "ui/views/side_by_side.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

#include "core/analysis/programmed_place.h"
#include "ui/models/panel_action.h"

namespace feedscope::ui {

SideBySide::SideBySide(Workbench& model, SceneView& first, RenderBackend backend, QWidget* parent)
    : QWidget(parent),
      model_(model),
      first_(first),
      backend_(backend),
      splitter_(new QSplitter(this)),
      action_(make_action(this, tr("Two views &side by side"),
                          tr("Another run beside the current one, turned and coloured alike"),
                          QKeySequence(tr("Ctrl+8")))) {
  action_->setCheckable(true);
  connect(action_, &QAction::toggled, this, &SideBySide::set_on);
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(&first_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter_);
  connect(&first_, &SceneView::changed, this, [this] {
    if (second_ != nullptr) {
      link(first_, *second_);
    }
  });
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&model_.runs(), signal, this, &SideBySide::list_runs);
  }
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&model_.runs(), signal, this, &SideBySide::list_runs);
  }
  connect(&model_.cursor(), &Cursor::changed, this, &SideBySide::show_cursor);
}

void SideBySide::set_on(bool on) {
  if (on != this->on()) {
    on ? open() : close();
    action_->setChecked(on);
  }
}

void SideBySide::open() {
  side_ = new QWidget(splitter_);
  second_ = new SceneView(backend_, side_);
  choice_ = new QComboBox(side_);
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(12);
  choice_->setToolTip(tr("The run in the view on the right"));
  choice_->setAccessibleName(tr("Run in the second view"));
  second_->add_to_bar(*choice_);
  auto* layout = new QVBoxLayout(side_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(second_);
  splitter_->addWidget(side_);
  const int half = splitter_->width() / 2;
  splitter_->setSizes({half, half});
  connect(choice_, &QComboBox::currentIndexChanged, this, &SideBySide::show_run);
  connect(second_, &SceneView::changed, this, [this] { link(*second_, first_); });
  connect(second_, &SceneView::picked, this, [this](double time) {
    if (shown_ != nullptr && model_.cursor().valid()) {
      model_.cursor().set_time(
          time_of(*model_.cursor().trajectory(), programmed_place(*shown_->run.trajectory, time)));
    }
  });
  list_runs();
  link(first_, *second_);
}

void SideBySide::close() {
  shown_.reset();
  second_ = nullptr;
  choice_ = nullptr;
  delete std::exchange(side_, nullptr);
}

/// All runs but the current one; the one that was chosen stays, else the first.
void SideBySide::list_runs() {
  if (second_ == nullptr) {
    return;
  }
  const int chosen = choice_->currentData().toInt();
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    const RunList& runs = model_.runs();
    for (std::size_t row = 0; row < runs.items().size(); ++row) {
      if (row != runs.current()) {
        choice_->addItem(run_title(runs.items()[row]), runs.items()[row].id);
      }
    }
    if (choice_->count() == 0) {
      choice_->addItem(tr("Duplicate the run to compare (Ctrl+D)"), 0);
    }
    choice_->setCurrentIndex(std::max(0, choice_->findData(chosen)));
  }
  show_run();
}

std::size_t SideBySide::other_row() const {
  return model_.runs().row_of(choice_->currentData().toInt());
}

void SideBySide::show_run() {
  const RunList& runs = model_.runs();
  const std::size_t row = other_row();
  const auto result = row < runs.items().size() ? runs.result(row) : nullptr;
  if (result == shown_ && shown_ != nullptr) {
    return;
  }
  shown_ = result;
  const bool any = shown_ != nullptr;
  linking_ = true;
  PathScene& scene = second_->scene();
  scene.set_programmed(model_.shown_program().samples);
  scene.set_executed(any ? shown_->run.trajectory : nullptr, any ? shown_->samples : nullptr);
  linking_ = false;
  link(first_, *second_);
  show_cursor();
}

void SideBySide::show_cursor() {
  if (second_ == nullptr) {
    return;
  }
  const Cursor& cursor = model_.cursor();
  if (shown_ == nullptr || !cursor.valid()) {
    second_->scene().set_cursor(std::nullopt);
    return;
  }
  const Trajectory& trajectory = *shown_->run.trajectory;
  const ProgrammedPlace place = programmed_place(*cursor.trajectory(), cursor.state().time);
  second_->scene().set_cursor(trajectory.state(time_of(trajectory, place)));
}

void SideBySide::link(SceneView& from, SceneView& to) {
  if (linking_ || from.state() == to.state()) {
    return;
  }
  linking_ = true;
  to.set_state(from.state());
  linking_ = false;
}

}  // namespace feedscope::ui
