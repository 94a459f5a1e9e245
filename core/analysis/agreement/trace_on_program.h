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

/// How much farther from the path a trace of another machine may be than a run [mm].
inline constexpr double usual_deviation = 0.2;
/// Distance from rest at which a motion has begun [mm].
inline constexpr double begun_motion = 2e-3;

/// A stretch of a trace, between two samples on the path, in which nothing can be compared.
struct LostStretch {
  double from = 0;  ///< of the trace [s]
  double to = 0;
  double from_s = 0;  ///< programmed path length [mm]
  double to_s = 0;
  bool recorded = false;  ///< samples exist, but are too far from the path
  bool jumps = false;     ///< the positions are farther apart than the tool can have travelled
};

/// A trace found on the path of its program.
struct TraceOnProgram {
  SamplingRate rate;
  TracePose pose;
  double tolerance = 0;             ///< allowed distance from the programmed path [mm]
  double noise = 0;                 ///< of its positions [mm]
  MotionRecord record;              ///< in the coordinates of the program
  MatchedRecord matched;            ///< of the first pass
  TimeLaw law;                      ///< of the first pass
  TraceFit fit;                     ///< of the first pass
  std::vector<LostStretch> lost;    ///< of the first pass, in order
  double largest_distance = 0;      ///< from the programmed path [mm]
  std::vector<double> pass_times;   ///< of whole passes through the program [s]
  std::vector<Diagnostic> remarks;  ///< from remarks_on()
  double share = 0;                 ///< of the programmed path that it covers, without lost stretches

  /// Whether the stretch of path is lost at least in part; `recorded_alone`: only samples that are too far
  /// from it count.
  bool loses(double from_s, double to_s, bool recorded_alone = false) const;
  /// Whether the trace belongs to this program at all: half of the trace follows the path, or it follows half
  /// of the path.
  bool belongs() const;
};

/// Positions of a trace as recorded.
MotionRecord record_of(const Trace& trace);

/// Finds a trace on the path of a run: unit, signs and offset of its axes, start and end, passes. A trace of
/// which only a small part would fit stays in its own coordinates. Its lines are lines of the file or block
/// numbers of `source`, whichever fits; null: block numbers are unknown. `deviation`: how far a control may
/// leave the path here [mm]. Throws Cancelled.
TraceOnProgram find_on_program(const Trace& trace, const ProgrammedCourse& course, double deviation,
                               const SourceText* source = nullptr, Progress* progress = nullptr);

/// Remarks on a trace found on a program that restrict the use of its figures, each with what remains usable.
/// `trace`: as recorded.
std::vector<Diagnostic> remarks_on(const TraceOnProgram& found, const Trace& trace,
                                   const ProgrammedCourse& course);

}  // namespace feedscope
