#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/agreement/corner_agreement.h"
#include "core/analysis/agreement/time_law.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "core/analysis/run/run.h"
#include "core/analysis/study/operations.h"

namespace feedscope {

/// A stretch of the programmed path, run by a trace and by a simulation.
struct AgreementCell {
  double s = 0;              ///< programmed path length at its start [mm]
  double length = 0;         ///< [mm]
  double measured_time = 0;  ///< [s]
  double simulated_time = 0;

  double measured_feed() const { return measured_time > 0 ? length / measured_time : 0; }  ///< [mm/s]
  double simulated_feed() const { return simulated_time > 0 ? length / simulated_time : 0; }
};

/// A place where trace and simulation differ most.
struct WorstPlace {
  std::uint32_t line = 0;
  double s = 0;  ///< programmed path length [mm]
  Vec3 place = Vec3::Zero();
  double measured_feed = 0;  ///< over a short stretch [mm/s]
  double simulated_feed = 0;
  double lost = 0;  ///< measured minus simulated time of the stretch [s]
};

/// Times of one operation of the program.
struct OperationAgreement {
  std::string title;
  std::uint32_t line = 0;
  double measured_time = 0;  ///< [s]
  double simulated_time = 0;
};

/// Agreement of a simulated run with a trace, over the part of the program that the trace covers.
struct Agreement {
  SamplingRate rate;          ///< of the trace; of section times: none
  double measured_time = 0;   ///< from the first to the last motion [s]
  double simulated_time = 0;  ///< of the same part [s]
  bool whole = false;         ///< the trace covers the program: the times are cycle times
  double held_time = 0;       ///< part of `measured_time` by which the trace stops longer than the run [s]
  double feed_rms = 0;        ///< root mean square of the difference of the feeds over the path [mm/s]
  double distance = 0;        ///< of the trace from the programmed path, largest [mm]
  double simulated_distance = 0;     ///< of the simulated run, likewise [mm]
  std::vector<AgreementCell> cells;  ///< without stretches that the trace has lost or in which it stops
  std::vector<WorstPlace> worst;     ///< at most ten, largest difference of time first
  std::vector<OperationAgreement> operations;   ///< empty if the program has only one
  OperationSplit split = OperationSplit::tool;  ///< of the operations; by comment if there is only one tool
  std::vector<CornerAgreement>
      corners;        ///< that both pass and where the trace does not stop, in order of the program
  TimeLaw simulated;  ///< of the run, on the programmed path like that of the trace
  double margin = 0;  ///< distance from rest at which a motion counts as begun [mm]

  /// Root mean square of CornerAgreement::error(); 0 without corners.
  double corner_rms() const;
  /// As time_error(), without the time that the trace is stopped.
  double time_error_without_holds() const {
    const double moving = measured_time - held_time;
    return moving > 0 ? simulated_time / moving - 1 : 0;
  }
  double time_error() const { return measured_time > 0 ? simulated_time / measured_time - 1 : 0; }
};

/// Motion of a run, sampled every `step` [s]. Throws Cancelled when stopped.
MotionRecord record_of(const Trajectory& trajectory, double step, const Progress* progress = nullptr);

/// Largest distance of a run from its programmed path, as the matching measures it [mm]. Throws Cancelled
/// when stopped.
double deviation_of(const Trajectory& trajectory, const ProgrammedCourse& course, double step,
                    Progress* progress = nullptr);

/// Compares a trace with a run. Throws InputError with the distance if no part of the trace is on the path of
/// the program.
Agreement agreement_of(const TraceOnProgram& trace, const ProgrammedCourse& course, const Run& run,
                       Progress* progress = nullptr);

/// Ends of stretches of the programmed path, none shorter than `least_time` [s] or `least_length` [mm]; the
/// trace is known at each. None is near a pause, where noise decides on which side the pause falls.
std::vector<double> cell_borders(const TimeLaw& law, double least_time, double least_length);

}  // namespace feedscope
