#include "ui/scene_view/side_by_side.h"

#include <QActionGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTimer>
#include <cmath>
#include <utility>

#include "core/analysis/contour/programmed_place.h"
#include "ui/annotations/annotation_overlay.h"
#include "ui/scene_view/lens_overlay.h"
#include "ui/scene_view/split_overlay.h"
#include "ui/shared/panel_action.h"

namespace feedscope::ui {
namespace {

/// `state` of one view converted for another, so that a millimetre has the same size in both.
SceneState between_views(SceneState state, SceneView& from, SceneView& to) {
  const int height = from.canvas().height();
  if (height > 0 && to.canvas().height() > 0) {
    state.camera.height *= static_cast<double>(to.canvas().height()) / height;
  }
  return state;
}

/// Equality up to rounding, except for whether the camera is fitted.
bool same_look(SceneState a, const SceneState& b) {
  constexpr double rounding = 1e-9;
  const double tiny = rounding * b.camera.height;
  if (std::abs(a.camera.height - b.camera.height) <= tiny) {
    a.camera.height = b.camera.height;
  }
  if ((a.camera.focal - b.camera.focal).norm() <= tiny) {
    a.camera.focal = b.camera.focal;
  }
  a.camera.fitted = b.camera.fitted;
  return a == b;
}

}  // namespace

SideBySide::SideBySide(Workbench& workbench, SceneView& first, RenderBackend backend, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      first_(first),
      backend_(backend),
      comparison_(workbench.runs()),
      first_run_(first, workbench.runs(), comparison_),
      splitter_(new QSplitter(this)),
      references_(new QMenu(tr("Compare &with"), this)),
      lens_(new LensOverlay(workbench, first)) {
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(&first_);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter_);
  make_actions();
  make_comparison_menu();
  connect(&first_, &SceneView::changed, this, [this] {
    if (second_ != nullptr) {
      link(first_);
    }
  });
  connect(&first_run_, &SceneRun::changed, this, &SideBySide::share_colour_scale);
  connect(&comparison_, &RunComparison::cancelled, this, [this] {
    SceneState look = first_.state();  // followed by a second view
    look.colouring = Colouring::feed;
    first_.set_state(look);
  });
  follow_workbench();
  show_program();
  show_current();
  show_overlays();
}

SideBySide::~SideBySide() {
  close();
}

void SideBySide::follow_workbench() {
  const auto show_runs = [this] {
    list_runs();
    show_overlays();
  };
  RunList& runs = workbench_.runs();
  for (const auto signal : {&RunList::list_changed, &RunList::current_changed}) {
    connect(&runs, signal, this, show_runs);
  }
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&runs, signal, this, show_runs);
  }
  connect(&runs, &RunList::item_changed, this, &SideBySide::show_run_name);
  connect(&workbench_.traces(), &TraceList::list_changed, this, &SideBySide::show_overlays);
  connect(&workbench_.traces(), &TraceList::changed, this, &SideBySide::show_overlays);
  connect(&workbench_, &Workbench::program_changed, this, &SideBySide::show_program);
  connect(&workbench_, &Workbench::drawn_changed, this, &SideBySide::show_current);
  connect(&workbench_.cursor(), &Cursor::changed, this, &SideBySide::show_cursor);
  ViewRange& range = workbench_.view_range();
  connect(&range, &ViewRange::changed, &first_,
          [this, &range] { first_.show_times(range.lower_time(), range.upper_time()); });
  connect(&first_, &SceneView::changed, &range,
          [this, &range] { range.show_rapids(first_.scene().rapids_shown()); });
  connect(&range, &ViewRange::rapids_shown_changed, &first_,
          [this](bool shown) { first_.scene().set_rapids_shown(shown); });
  connect(&first_, &SceneView::times_chosen, &range, &ViewRange::show_times);
  connect(&first_, &SceneView::picked, &workbench_.cursor(), &Cursor::set_time);
  first_.annotations().set_annotations(&workbench_.annotations());
}

void SideBySide::show_program() {
  const auto program = workbench_.program();
  PathScene& scene = first_.scene();
  scene.set_programmed(workbench_.shown_program().samples);
  if (program != nullptr && std::exchange(fitted_to_, workbench_.file()) != workbench_.file()) {
    scene.fit();  // the camera's place in the previous program is meaningless in this one
  }
}

void SideBySide::make_actions() {
  beside_ = add_mode(ScenesMode::side_by_side, tr("Two views &side by side"),
                     tr("Another run beside the current one, with the same camera and colours"),
                     QKeySequence(tr("Ctrl+8")));
  across_ = add_mode(ScenesMode::split, tr("Split vie&w"),
                     tr("The current run to the left of a draggable line, another one to the right"),
                     QKeySequence(tr("Ctrl+Shift+8")));
  const auto add_step = [this](const QString& text, const QString& tip, const QKeySequence& key, int steps) {
    QAction* action = make_action(this, text, tip, key);
    connect(action, &QAction::triggered, this, [this, steps] {
      if (split_ != nullptr) {
        split_->step(steps);
      }
    });
    actions_.append(action);
  };
  add_step(tr("Dividing line &left"), tr("Move the dividing line to the left"),
           QKeySequence(tr("Ctrl+Shift+Left")), -1);
  add_step(tr("Dividing line ri&ght"), tr("Move the dividing line to the right"),
           QKeySequence(tr("Ctrl+Shift+Right")), 1);
  actions_.append(lens_->action());
}

QAction* SideBySide::add_mode(ScenesMode mode, const QString& text, const QString& tip,
                              const QKeySequence& key) {
  QAction* action = make_action(this, text, tip, key);
  action->setCheckable(true);
  connect(action, &QAction::toggled, this, [this, mode](bool on) {
    set_mode(on ? mode : mode_ == mode ? ScenesMode::one : mode_);
  });
  actions_.append(action);
  return action;
}

void SideBySide::make_comparison_menu() {
  references_->setToolTip(tr("The reference run for time lost and distances"));
  connect(references_, &QMenu::aboutToShow, this, &SideBySide::list_references);
  first_.add_comparison_menu(*references_);
  list_references();
}

/// Built when it is opened, because other lists of commands keep its actions.
void SideBySide::list_references() {
  references_->clear();
  delete references_->findChild<QActionGroup*>();
  auto* group = new QActionGroup(references_);
  const auto add = [&](const QString& text, int id) {
    QAction* action = references_->addAction(text);
    action->setCheckable(true);
    action->setChecked(comparison_.chosen() == id);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, id] { comparison_.choose(id); });
  };
  add(tr("The run in the second view, or the first other run"), 0);
  const RunList& runs = workbench_.runs();
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    add(runs.lettered_title(row), runs.items()[row].id);
  }
}

void SideBySide::set_mode(ScenesMode mode) {
  if (mode != mode_) {
    close();
    mode_ = mode;
    if (mode_ != ScenesMode::one) {
      open();
    }
    lens_->set_offered(mode_ == ScenesMode::one);  // two views already show the runs side by side
    show_overlays();
  }
  beside_->setChecked(mode_ == ScenesMode::side_by_side);
  across_->setChecked(mode_ == ScenesMode::split);
}

ScenesState SideBySide::state() const {
  const RunList& runs = workbench_.runs();
  const auto row_of = [&](int id) {
    const std::size_t row = runs.row_of(id);
    return row < runs.items().size() ? std::optional(row) : std::nullopt;
  };
  return {mode_, row_of(other_), share_, row_of(comparison_.chosen())};
}

void SideBySide::set_state(const ScenesState& state) {
  const std::vector<RunItem>& items = workbench_.runs().items();
  const auto id_of = [&](std::optional<std::size_t> row) {
    return row && *row < items.size() ? items[*row].id : 0;
  };
  other_ = id_of(state.other);
  share_ = state.split;
  comparison_.choose(id_of(state.reference));
  set_mode(state.mode);
  if (split_ != nullptr) {
    split_->set_share(share_);
  }
  list_runs();
}

void SideBySide::rest() {
  for (SceneView* view : {&first_, second_}) {
    if (view != nullptr) {
      view->rest();
    }
  }
}

void SideBySide::open() {
  second_ = new SceneView(backend_, this);
  second_->set_state(first_.state());  // before its state reaches the first view
  make_choice(second_);
  second_->take_commands_of(first_);
  if (mode_ == ScenesMode::side_by_side) {
    first_name_ = new QLabel;
    first_name_->setContentsMargins(4, 0, 4, 0);
    named_ = first_.add_to_bar(*first_name_);
    second_->add_to_bar(*choice_);
    splitter_->addWidget(second_);
    const int bar = std::max(first_.bar_height(), second_->bar_height());
    first_.set_bar_height(bar);
    second_->set_bar_height(bar);
    const int half = splitter_->width() / 2;
    splitter_->setSizes({half, half});
  } else {
    split_ = std::make_unique<SplitOverlay>(first_, second_, choice_, share_);
    connect(split_.get(), &SplitOverlay::share_changed, this, [this](double share) { share_ = share; });
  }
  second_->scene().set_legend(mode_ != ScenesMode::side_by_side);  // the first view explains both
  for (SceneView* view : {&first_, second_}) {
    view->canvas().installEventFilter(this);
  }
  second_->add_comparison_menu(*references_);
  second_run_ = std::make_unique<SceneRun>(*second_, workbench_.runs(), comparison_);
  connect(second_run_.get(), &SceneRun::changed, this, &SideBySide::share_colour_scale);
  AnnotationOverlay& annotations = second_->annotations();
  annotations.set_annotations(&workbench_.annotations());
  connect(&annotations, &AnnotationOverlay::edit_wanted, &first_.annotations(),
          &AnnotationOverlay::edit_wanted);
  connect(second_, &SceneView::changed, this, [this] { link(*second_); });
  connect(second_, &SceneView::picked, this, [this](double time) {
    const auto& shown = second_run_->shown();
    if (shown != nullptr && workbench_.cursor().valid()) {
      workbench_.cursor().set_time(
          time_of(*workbench_.cursor().trajectory(), programmed_place(*shown->run.trajectory, time)));
    }
  });
  list_runs();
  link(first_);
}

void SideBySide::make_choice(QWidget* parent) {
  choice_ = new QComboBox(parent);
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  choice_->setMinimumContentsLength(12);
  choice_->setToolTip(tr("The run in the view on the right"));
  choice_->setAccessibleName(tr("Run in the second view"));
  connect(choice_, &QComboBox::activated, this, [this] {
    other_ = choice_->currentData().toInt();
    show_run();
  });
}

void SideBySide::close() {
  second_run_.reset();
  first_.canvas().removeEventFilter(this);
  choice_ = nullptr;
  first_name_ = nullptr;
  delete std::exchange(named_, nullptr);
  SceneView* view = std::exchange(second_, nullptr);
  if (split_ != nullptr) {
    split_.reset();  // also deletes the view
  } else {
    delete view;
  }
  comparison_.set_beside(0);
  first_run_.share_scale_with(nullptr);
  first_run_.set_halves(false);
}

/// Lists all runs except the current one; keeps the chosen one, else the first.
void SideBySide::list_runs() {
  if (second_ == nullptr) {
    return;
  }
  choice_->clear();
  const RunList& runs = workbench_.runs();
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    if (row != runs.current()) {
      const RunItem& run = runs.items()[row];
      QPixmap colour(12, 12);
      colour.fill(run.colour);
      choice_->addItem(QIcon(colour), runs.lettered_title(row), run.id);
    }
  }
  if (choice_->count() == 0) {
    choice_->addItem(tr("Duplicate the run to compare (Ctrl+D)"), 0);
  }
  choice_->setCurrentIndex(std::max(0, choice_->findData(other_)));
  show_run();
}

void SideBySide::show_current() {
  const auto shown = workbench_.drawn();
  PathScene& scene = first_.scene();
  scene.set_programmed(shown != nullptr && shown->programmed != nullptr ? shown->programmed
                                                                        : workbench_.shown_program().samples);
  first_run_.show(workbench_.runs().current_item().id);
  show_run_name();
  show_cursor();
}

void SideBySide::show_run_name() {
  const auto shown = workbench_.drawn();
  first_.annotations().set_run(shown != nullptr ? shown->run.trajectory : nullptr,
                               workbench_.runs().title(workbench_.runs().current_item()),
                               shown != nullptr ? shown->run.sources : RunSources());
}

void SideBySide::show_overlays() {
  const RunList& runs = workbench_.runs();
  std::vector<OverlayRun> overlays;
  const auto rgb = [](const QColor& colour) { return Rgb{colour.redF(), colour.greenF(), colour.blueF()}; };
  for (std::size_t row = 0; row < runs.items().size(); ++row) {
    const auto result = runs.result(row);
    const RunItem& item = runs.items()[row];
    // In a split view the other run has its half.
    if (row != runs.current() && item.visible && result != nullptr && mode_ != ScenesMode::split) {
      const auto current = runs.result(runs.current());
      const double apart =
          current == nullptr ? HUGE_VAL
                             : current->run.summary.max_contour_error + result->run.summary.max_contour_error;
      overlays.push_back({result->samples, rgb(item.colour), runs.lettered_title(row).toStdString(), apart});
    }
  }
  const TraceList& traces = workbench_.traces();
  for (std::size_t row = 0; row < traces.items().size(); ++row) {
    const TraceItem& item = traces.items()[row];
    if (const auto shown = traces.result(row); item.visible && shown != nullptr) {
      overlays.push_back({shown->samples, rgb(item.colour), item.name.toStdString()});
    }
  }
  first_.scene().set_run_colour(rgb(runs.current_item().colour));
  first_.scene().set_overlays(std::move(overlays));
}

void SideBySide::show_run() {
  const int id = choice_->currentData().toInt();
  comparison_.set_beside(id);
  linking_ = true;
  const RunList& runs = workbench_.runs();
  QString title;
  PathScene& scene = second_->scene();
  scene.set_programmed(workbench_.shown_program().samples);
  if (const std::size_t row = runs.row_of(id); row < runs.items().size()) {
    const QColor& colour = runs.items()[row].colour;
    scene.set_run_colour({colour.redF(), colour.greenF(), colour.blueF()});
    title = runs.title(runs.items()[row]);
  }
  second_run_->show(id);
  const auto& shown = second_run_->shown();
  if (shown != nullptr) {
    scene.set_programmed(shown->programmed != nullptr ? shown->programmed
                                                      : workbench_.shown_program().samples);
  }
  second_->annotations().set_run(shown != nullptr ? shown->run.trajectory : nullptr, title,
                                 shown != nullptr ? shown->run.sources : RunSources());
  linking_ = false;
  share_colour_scale();
  link(first_);
  show_cursor();
}

void SideBySide::share_colour_scale() {
  if (second_run_ != nullptr) {
    first_run_.share_scale_with(second_run_->samples());
    second_run_->share_scale_with(first_run_.samples());
  }
  show_names();
}

void SideBySide::show_names() {
  const RunList& runs = workbench_.runs();
  const QString current = runs.lettered_title(runs.current());
  const QString mark = run_mark(current, runs.current_item().colour);
  if (first_name_ != nullptr) {
    first_name_->setText(mark);
  }
  const bool halves = split_ != nullptr && second_run_ != nullptr &&
                      first_run_.reference_name() == choice_->currentText() &&
                      second_run_->reference_name() == current;
  first_run_.set_halves(halves);
  if (second_run_ != nullptr) {
    second_run_->set_halves(halves);
  }
  if (split_ == nullptr) {
    return;
  }
  split_->set_left_name(mark);
  // That the halves are compared with each other goes without saying.
  const auto against = [&](const SceneRun& run, const QString& beside) {
    const QString& name = run.reference_name();
    return name.isEmpty() || name == beside ? QString() : tr("compared with %1").arg(name);
  };
  split_->set_notes(against(first_run_, choice_->currentText()),
                    second_run_ != nullptr ? against(*second_run_, current) : QString());
}

void SideBySide::show_cursor() {
  const Cursor& cursor = workbench_.cursor();
  cursor.valid() ? first_.scene().set_cursor(cursor.state()) : first_.scene().set_cursor(std::nullopt);
  if (second_ == nullptr || second_run_ == nullptr) {
    return;
  }
  const auto& shown = second_run_->shown();
  if (shown == nullptr || !cursor.valid()) {
    second_->scene().set_cursor(std::nullopt);
    return;
  }
  const Trajectory& trajectory = *shown->run.trajectory;
  const ProgrammedPlace place = programmed_place(*cursor.trajectory(), cursor.state().time);
  second_->scene().set_cursor(trajectory.state(time_of(trajectory, place)));
}

/// Keeps both views equal, pixel by pixel: only the first one fits, and passes its state on.
void SideBySide::link(SceneView& from) {
  if (linking_) {
    return;
  }
  linking_ = true;
  if (&from != &first_) {
    const SceneState wanted = between_views(from.state(), from, first_);
    if (wanted.camera.fitted || !same_look(first_.state(), wanted)) {
      first_.set_state(wanted);
    }
  }
  SceneState wanted = between_views(first_.state(), first_, *second_);
  wanted.camera.fitted = false;
  if (second_->state().camera.fitted || !same_look(second_->state(), wanted)) {
    second_->set_state(wanted);
  }
  linking_ = false;
}

/// The first view may have changed size, or been fitted again during drawing.
void SideBySide::follow_first() {
  if (second_ != nullptr && !same_look(second_->state(), between_views(first_.state(), first_, *second_))) {
    link(first_);
  }
}

bool SideBySide::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Paint || event->type() == QEvent::Resize) {
    // Waits until the canvas and its fit have been updated.
    QMetaObject::invokeMethod(this, &SideBySide::follow_first, Qt::QueuedConnection);
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace feedscope::ui
