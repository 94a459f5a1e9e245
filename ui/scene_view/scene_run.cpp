#include "ui/scene_view/scene_run.h"

#include <QScopedValueRollback>

#include "ui/scene/path/pick.h"
#include "ui/scene_view/scene_texts.h"

namespace feedscope::ui {

SceneRun::SceneRun(SceneView& view, RunList& runs, RunComparison& comparison, QObject* parent)
    : QObject(parent), view_(view), runs_(runs), comparison_(comparison) {
  connect(&view_, &SceneView::changed, this, [this] {
    if (needs_reference(view_.scene().colouring()) != compares_) {
      follow();
    }
  });
  connect(&comparison_, &RunComparison::ready, this, &SceneRun::follow);
  connect(&comparison_, &RunComparison::reference_changed, this, &SceneRun::follow);
  connect(&runs_, &RunList::list_changed, this, &SceneRun::follow_runs);
  for (const auto signal : {&RunList::item_changed, &RunList::result_changed}) {
    connect(&runs_, signal, this, &SceneRun::follow_runs);
  }
  view_.set_hover_more([this](double time) { return hover_text(time); });
  follow_runs();
}

void SceneRun::show(int id) {
  id_ = id;
  follow();
}

void SceneRun::share_scale_with(std::shared_ptr<const SampledPath> samples) {
  if (samples != scale_with_) {
    scale_with_ = std::move(samples);
    show_comparison();
  }
}

void SceneRun::set_halves(bool halves) {
  if (halves != halves_) {
    halves_ = halves;
    show_comparison();
  }
}

void SceneRun::show_comparison() {
  const QString name = halves_ && !reference_name_.isEmpty() ? tr("the other half") : reference_name_;
  view_.scene().set_comparison(name.toStdString(), scale_with_);
}

void SceneRun::follow_runs() {
  view_.set_comparable(runs_.items().size() > 1);
  follow();
}

void SceneRun::follow() {
  if (following_) {
    return;
  }
  const QScopedValueRollback<bool> guard(following_, true);
  PathScene& scene = view_.scene();
  const std::size_t row = runs_.row_of(id_);
  const bool known = row < runs_.items().size();
  const auto before = samples_;
  const QString name_before = reference_name_;
  const auto run_before = scene.trajectory();
  shown_ = known ? runs_.drawn(row) : nullptr;
  samples_ = shown_ != nullptr ? shown_->samples : nullptr;
  reference_.reset();
  reference_name_.clear();
  if (needs_reference(scene.colouring()) && runs_.items().size() < 2) {
    scene.set_colouring(Colouring::feed);
  }
  if (shown_ != nullptr && !shown_->run.sources.has(source_of(scene.colouring()))) {
    scene.set_colouring(Colouring::feed);
  }
  compares_ = needs_reference(scene.colouring());
  const auto reference = compares_ && known ? comparison_.reference_of(row) : std::nullopt;
  if (reference) {
    reference_name_ = runs_.lettered_title(*reference);
    if (const auto compared = comparison_.samples(row)) {
      samples_ = compared;
      reference_ = runs_.result(*reference);
    }
  }
  const auto run = shown_ != nullptr ? shown_->run.trajectory : nullptr;
  if (samples_ != before || run != run_before) {
    if (samples_ != nullptr && samples_->levels.size() > 1) {
      view_.begin_rest();  // the run is seen at once, all of its detail a little later
    }
    scene.set_executed(run, samples_);
  }
  show_comparison();
  if (samples_ != before || reference_name_ != name_before) {
    emit changed();
  }
}

QString SceneRun::hover_text(double time) const {
  QStringList texts;
  if (shown_ != nullptr) {
    const State state = shown_->run.trajectory->state(time);
    InstantSampler sampler(shown_->run.sources, time);
    const Instant instant = sampler.at(state);
    texts = {instant.actual != nullptr ? drives_text(*instant.actual) : QString(),
             instant.load != nullptr ? load_text(*instant.load) : QString()};
  }
  texts.append(compared_text(time));
  texts.removeAll(QString());
  return texts.join('\n');
}

QString SceneRun::compared_text(double time) const {
  if (!compares_ || reference_ == nullptr || shown_ == nullptr) {
    return {};
  }
  const PickablePath path{samples_.get(), &samples_->positions, &samples_->boxes};
  PlaceComparison place;
  place.reference = reference_name_;
  place.time = time;
  place.lost = lost_at(path, time).value_or(0);
  place.pace = value_at(path, Colouring::time_lost, time);
  place.distance = value_at(path, Colouring::path_distance, time);
  place.feed = shown_->run.trajectory->state(time).speed;
  place.reference_feed = reference_->run.trajectory->state(time - place.lost).speed;
  return comparison_text(place);
}

}  // namespace feedscope::ui
