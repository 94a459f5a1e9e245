#pragma once

#include <memory>

#include "core/analysis/envelope/envelope.h"
#include "core/analysis/run/run.h"
#include "core/analysis/time/line_times.h"
#include "core/analysis/time/slow_places.h"
#include "core/base/progress.h"
#include "ui/scene/sampled_path.h"

namespace feedscope::ui {

/// A run with the data of its pictures, made outside the GUI thread.
struct ShownRun {
  Run run;
  std::shared_ptr<const Envelope> envelope;    ///< for the charts
  std::shared_ptr<const SampledPath> samples;  ///< for the 3D view
  /// Of the programmed path with the moves that this machine adds, see on_machine(); null: it adds none.
  std::shared_ptr<const SampledPath> programmed = nullptr;
  std::shared_ptr<const LineTimes> line_times;  ///< for the program's text
  std::shared_ptr<const SlowPlaces> slow_places;
};

/// Parts of a ShownRun that a picture needs in addition to the run.
struct ShownParts {
  bool path = true;    ///< samples, programmed
  bool charts = true;  ///< envelope
  bool lines = true;   ///< line_times, slow_places
  bool summary = true;
};

/// Throws Cancelled if `progress` is cancelled.
std::shared_ptr<const ShownRun> make_shown(Run run, Progress* progress = nullptr);

/// A program with the data of its picture before the first run is ready.
struct ShownProgram {
  LoadedProgram input;
  std::shared_ptr<const SampledPath> samples;  ///< of the programmed path
};

ShownProgram make_shown(LoadedProgram input);
/// The program of a run, with the path as the machine runs it.
ShownProgram program_of(const Run& run);

}  // namespace feedscope::ui
