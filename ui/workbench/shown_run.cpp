#include "ui/workbench/shown_run.h"

#include <atomic>
#include <utility>

#include "core/analysis/run/run_stages.h"
#include "core/base/parallel.h"
#include "ui/workbench/simulate_shown.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t slow_places_kept = 10'000;

// Fractions of a run's computing time, as measured with several models.
constexpr double share_of_motion = 0.45;
constexpr double share_of_load = 0.3;  // if the motion is known
struct Shares {
  double samples = 0.35, summary = 0.2, envelope = 0.25, lines = 0.1, places = 0.1;  // of the remaining time
};

/// Parameters of making a ShownRun.
struct Making {
  Progress& progress;
  double share = 1;                  ///< of `progress`
  const Toolpath* input = nullptr;   ///< simulated path, with the summary to come; null: the run's
  const ShownRun* before = nullptr;  ///< deviations requested of its samples are computed again
  ShownParts parts = {};
  DrawableRun drawable = {};
};

/// Parts of a ShownRun for `run`, computed in parallel.
std::shared_ptr<const ShownRun> shown_of(Run run, const Making& how) {
  const bool with_deviations = how.before != nullptr && how.before->samples &&
                               how.before->samples->deviations && how.before->samples->deviations->asked();
  auto drawn = std::make_shared<ShownRun>();  // not changed after it is passed on
  drawn->run = run;
  const std::shared_ptr<const Trajectory> trajectory = run.trajectory;
  ShownRun rest;
  const Shares of;
  Progress samples(how.progress, of.samples * how.share);
  Progress summary(how.progress, of.summary * how.share);
  Progress envelope(how.progress, of.envelope * how.share);
  Progress lines(how.progress, of.lines * how.share);
  Progress places(how.progress, of.places * how.share);
  std::atomic<int> left_to_draw{2};
  const auto one_is_there = [&] {
    if (--left_to_draw == 0 && how.drawable) {
      how.drawable(drawn);
    }
  };
  // Two cores start with the first and the third.
  in_parallel({[&] {
                 const Toolpath* toolpath = drawn->run.path.toolpath.get();
                 if (how.parts.path) {
                   drawn->samples = std::make_shared<const SampledPath>(
                       sample_executed(trajectory, default_max_points, {}, &samples, drawn->run.sources));
                   if (with_deviations) {
                     drawn->samples->found_deviations();
                   }
                 }
                 if (how.parts.path && how.input != nullptr && how.input != toolpath) {
                   drawn->programmed = std::make_shared<const SampledPath>(sample_programmed(*toolpath));
                 } else if (how.parts.path && how.before != nullptr && how.input == nullptr) {
                   drawn->programmed = how.before->programmed;  // other load only: same motion
                 }
                 samples.report(1);
                 one_is_there();
               },
               [&] {
                 if (how.input != nullptr && how.parts.summary) {
                   add_summary(run, &summary);
                 }
                 summary.report(1);
               },
               [&] {
                 if (how.parts.charts) {
                   drawn->envelope =
                       std::make_shared<const Envelope>(trajectory, drawn->run.sources, &envelope);
                 }
                 envelope.report(1);
                 one_is_there();
               },
               [&] {
                 if (how.parts.lines) {
                   rest.line_times = std::make_shared<const LineTimes>(*trajectory, &lines);
                   rest.slow_places = std::make_shared<const SlowPlaces>(
                       find_slow_places(*trajectory, slow_places_kept, &places));
                 }
                 lines.report(1);
                 places.report(1);
               }});
  rest.run = std::move(run);
  rest.envelope = drawn->envelope;
  rest.samples = drawn->samples;
  rest.programmed = drawn->programmed;
  return std::make_shared<const ShownRun>(std::move(rest));
}

bool differ_in_load_alone(const Setup& a, Setup b) {
  b.load = a.load;
  return a == b;
}

}  // namespace

std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress) {
  Progress unwatched;
  return shown_of(std::move(run), {progress != nullptr ? *progress : unwatched});
}

std::shared_ptr<const ShownRun> simulate_shown(const LoadedProgram& input, Setup setup, Progress* progress,
                                               const ShownRun* before, const ShownParts& parts,
                                               const DrawableRun& drawable) {
  Progress unwatched;
  Progress& whole = progress != nullptr ? *progress : unwatched;
  if (before != nullptr && differ_in_load_alone(before->run.setup, setup)) {
    Progress load(whole, share_of_load);
    Run run = with_load(before->run, std::move(setup.load), &load);
    load.report(1);
    return shown_of(std::move(run), {whole, 1 - share_of_load, nullptr, before, parts, drawable});
  }
  Progress motion(whole, share_of_motion);
  Run run = simulate_motion(input, std::move(setup), &motion);
  motion.report(1);
  return shown_of(std::move(run),
                  {whole, 1 - share_of_motion, input.toolpath.get(), before, parts, drawable});
}

ShownProgram make_shown(LoadedProgram input) {
  auto samples = std::make_shared<const SampledPath>(sample_programmed(*input.toolpath));
  return {std::move(input), std::move(samples)};
}

ShownProgram program_of(const Run& run) {
  return {run.input, std::make_shared<const SampledPath>(sample_programmed(*run.path))};
}

}  // namespace feedscope::ui
