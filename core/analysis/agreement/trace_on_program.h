#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/agreement/path_matcher.h"
#include "core/analysis/agreement/programmed_course.h"
#include "core/analysis/agreement/time_law.h"
#include "core/analysis/agreement/trace_fit.h"
#include "core/analysis/agreement/trace_pose.h"
#include "core/base/diagnostic.h"
#include "core/program/text/source_text.h"
#include "core/trace/trace.h"

namespace feedscope {

/// Farther from the path than a run is, a trace of another machine may be [mm].
inline constexpr double usual_deviation = 0.2;
/// So far from where it stood, a motion has begun [mm].
inline constexpr double begun_motion = 2e-3;

/// A stretch of a trace, between two samples that are on the path, of which nothing can be compared.
struct LostStretch {
  double from = 0;  ///< of the trace [s]
  double to = 0;
  double from_s = 0;  ///< programmed path length [mm]
  double to_s = 0;
  bool recorded = false;  ///< there are samples, which are too far from the path
  bool jumps = false;     ///< the places are farther apart than the tool can have come
};

/// A trace found on the path of its program.
struct TraceOnProgram {
  SamplingRate rate;
  TracePose pose;
  double tolerance = 0;             ///< that was allowed from the programmed path [mm]
  double noise = 0;                 ///< of its places [mm]
  MotionRecord record;              ///< in the coordinates of the program
  MatchedRecord matched;            ///< of the first pass
  TimeLaw law;                      ///< of the first pass
  TraceFit fit;                     ///< of the first pass
  std::vector<LostStretch> lost;    ///< of the first pass, in its order
  double largest_distance = 0;      ///< from the programmed path [mm]
  std::vector<double> pass_times;   ///< of whole passes through the program [s]
  std::vector<Diagnostic> remarks;  ///< remarks_on() it
  double share = 0;                 ///< of the programmed path that it covers, lost stretches apart

  /// Whether a stretch of the path is lost, in part at least; `recorded` alone: that is too far from it.
  bool loses(double from_s, double to_s, bool recorded_alone = false) const;
  /// Whether it is a trace of this program at all: half of it runs along the path, or it along half of the
  /// path.
  bool belongs() const;
};

/// Positions of a trace as they are recorded.
MotionRecord record_of(const Trace& trace);

/// Finds a trace on the path of a run: unit, signs and offset of its axes, start and end, passes. Where only
/// a small part of the trace would fit, it is not moved: it stays in its own coordinates. Lines that the
/// trace holds are those of the file, or block numbers of `source`, whichever it fits by; null: no numbers
/// are known. `deviation`: how far a control may leave the path here [mm]. Throws Cancelled.
TraceOnProgram find_on_program(const Trace& trace, const ProgrammedCourse& course, double deviation,
                               const SourceText* source = nullptr, Progress* progress = nullptr);

/// What is to be known of a trace found on a program before its figures are trusted, each with what can still
/// be learnt. `trace`: as it was recorded.
std::vector<Diagnostic> remarks_on(const TraceOnProgram& found, const Trace& trace,
                                   const ProgrammedCourse& course);

}  // namespace feedscope
