#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/analysis/agreement/corner_agreement.h"
#include "core/analysis/agreement/time_law.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "core/analysis/run.h"
#include "core/analysis/study/operations.h"

namespace feedscope {

/// A stretch of the programmed path, run by a trace and by a simulation.
struct AgreementCell {
  double s = 0;              ///< programmed path length where it begins [mm]
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
  double lost = 0;  ///< measured less simulated time of it [s]
};

/// Times of one operation of the program.
struct OperationAgreement {
  std::string title;
  std::uint32_t line = 0;
  double measured_time = 0;  ///< [s]
  double simulated_time = 0;
};

/// How well a run says what a trace shows, over the part of the program that the trace covers.
struct Agreement {
  SamplingRate rate;              ///< of the trace; of section times none
  double measured_time = 0;       ///< from the first to the last motion [s]
  double simulated_time = 0;      ///< of the same part [s]
  bool whole = false;             ///< the trace covers the program: the times are cycle times
  double held_time = 0;           ///< in `measured_time`: that the trace stands still longer than the run [s]
  double feed_rms = 0;            ///< root mean square of the difference of the feeds over the path [mm/s]
  double distance = 0;            ///< largest of the trace from the programmed path [mm]
  double simulated_distance = 0;  ///< the same of the simulated run [mm]
  std::vector<AgreementCell> cells;  ///< without stretches that the trace has lost, or in which it is held
  std::vector<WorstPlace> worst;     ///< at most ten, the largest difference of time first
  std::vector<OperationAgreement> operations;   ///< empty: the program has one alone
  OperationSplit split = OperationSplit::tool;  ///< of the operations; by comment where there is one tool
  std::vector<CornerAgreement>
      corners;        ///< those that both pass where the trace is not held, in order of the program
  TimeLaw simulated;  ///< of the run, on the programmed path as the trace's
  double margin = 0;  ///< from where it stands: a motion has begun there [mm]

  /// Root mean square of CornerAgreement::error(); 0 without corners.
  double corner_rms() const;
  /// As time_error(), without what the trace is held.
  double time_error_without_holds() const {
    const double moving = measured_time - held_time;
    return moving > 0 ? simulated_time / moving - 1 : 0;
  }
  double time_error() const { return measured_time > 0 ? simulated_time / measured_time - 1 : 0; }
};

/// The motion of a run, sampled each `step` [s]. Throws Cancelled when stopped.
MotionRecord record_of(const Trajectory& trajectory, double step, const Progress* progress = nullptr);

/// The largest distance of a run from its programmed path, as the matching measures it [mm]. Throws
/// Cancelled when stopped.
double deviation_of(const Trajectory& trajectory, const ProgrammedCourse& course, double step,
                    Progress* progress = nullptr);

/// Compares. Throws InputError if the trace is nowhere on the path of the program, saying how far away it is.
Agreement agreement_of(const TraceOnProgram& trace, const ProgrammedCourse& course, const Run& run,
                       Progress* progress = nullptr);

/// Stretches of the programmed path, none shorter in time than `least_time` [s], at whose ends the trace is
/// known; `least_length` [mm]. None ends near a pause: on which side of the end it lies is a matter of noise.
std::vector<double> cell_borders(const TimeLaw& law, double least_time, double least_length);

}  // namespace feedscope
