#include "ui/workbench/shown_run.h"

#include <utility>

#include "core/analysis/run_stages.h"
#include "core/base/parallel.h"
#include "ui/workbench/simulate_shown.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t slow_places_kept = 10'000;

// Of the time that a run takes, as measured with several models.
constexpr double share_of_motion = 0.45;
constexpr double share_of_load = 0.3;  // where the motion is known
struct Shares {
  double samples = 0.35, summary = 0.2, envelope = 0.25, lines = 0.1, places = 0.1;  // of what follows
};

/// What is shown of `run`, each part beside the others, its summary too if that is still to come. `share`: of
/// `progress`; `input`: the toolpath that was simulated, null: that of the run; `before`: what was asked of
/// its samples is made of these at once.
std::shared_ptr<const ShownRun> shown_of(Run run, Progress& progress, double share, const Toolpath* input,
                                         const ShownRun* before, const ShownParts& parts) {
  const bool with_deviations = before != nullptr && before->samples && before->samples->deviations &&
                               before->samples->deviations->asked();
  auto shown = std::make_shared<ShownRun>();
  shown->run = std::move(run);
  const std::shared_ptr<const Trajectory> trajectory = shown->run.trajectory;
  const Shares of;
  Progress samples(progress, of.samples * share);
  Progress summary(progress, of.summary * share);
  Progress envelope(progress, of.envelope * share);
  Progress lines(progress, of.lines * share);
  Progress places(progress, of.places * share);
  // What takes longest first.
  in_parallel({[&] {
                 if (parts.path) {
                   shown->samples = std::make_shared<const SampledPath>(
                       sample_executed(trajectory, default_max_points, {}, &samples, shown->run.sources));
                   if (with_deviations) {
                     shown->samples->found_deviations();
                   }
                 }
                 samples.report(1);
               },
               [&] {
                 const Toolpath& toolpath = *shown->run.input.toolpath;
                 if (input != nullptr && parts.summary) {
                   add_summary(shown->run, &summary);
                 }
                 if (parts.path && input != nullptr && input != &toolpath) {
                   shown->programmed = std::make_shared<const SampledPath>(sample_programmed(toolpath));
                 }
                 summary.report(1);
               },
               [&] {
                 if (parts.charts) {
                   shown->envelope =
                       std::make_shared<const Envelope>(trajectory, shown->run.sources, &envelope);
                 }
                 envelope.report(1);
               },
               [&] {
                 if (parts.lines) {
                   shown->line_times = std::make_shared<const LineTimes>(*trajectory, &lines);
                   shown->slow_places = std::make_shared<const SlowPlaces>(
                       find_slow_places(*trajectory, slow_places_kept, &places));
                 }
                 lines.report(1);
                 places.report(1);
               }});
  return shown;
}

bool differ_in_load_alone(const Setup& a, Setup b) {
  b.load = a.load;
  return a == b;
}

}  // namespace

std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress) {
  Progress unwatched;
  return shown_of(std::move(run), progress != nullptr ? *progress : unwatched, 1, nullptr, nullptr, {});
}

std::shared_ptr<const ShownRun> simulate_shown(const LoadedProgram& input, Setup setup, Progress* progress,
                                               const ShownRun* before, const ShownParts& parts) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  if (before != nullptr && differ_in_load_alone(before->run.setup, setup)) {
    Progress load(whole, share_of_load);
    Run run = with_load(before->run, std::move(setup.load), &load);
    load.report(1);
    auto shown = std::make_shared<ShownRun>(
        *shown_of(std::move(run), whole, 1 - share_of_load, nullptr, before, parts));
    shown->programmed = before->programmed;
    return shown;
  }
  Progress motion(whole, share_of_motion);
  Run run = simulate_motion(input, std::move(setup), &motion);
  motion.report(1);
  return shown_of(std::move(run), whole, 1 - share_of_motion, input.toolpath.get(), before, parts);
}

ShownProgram make_shown(LoadedProgram input) {
  auto samples = std::make_shared<const SampledPath>(sample_programmed(*input.toolpath));
  return {std::move(input), std::move(samples)};
}

}  // namespace feedscope::ui
