#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/analysis/time_use/time_report.h"

namespace feedscope::ui {

/// Words for where the time goes, in the language and with the numbers of the user.
class TimeTexts {
  Q_DECLARE_TR_FUNCTIONS(TimeTexts)

 public:
  /// Rich text in two or three sentences: cycle time against programmed time, where most is lost, and how
  /// many lines the control refuses. `report`: on `run`, which is not refused.
  static QString conclusion(const TimeReport& report, const Run& run);
  /// Why there is no cycle time of a run that the control refuses.
  static QString refusal(const Run& run);
  static QString kind(TimeKind kind);
  /// "Jerk of axis X".
  static QString cause(Cause cause);
  /// lost_to() in the user's language.
  static QString lost_to(const SlowGroup& group);
  /// "Corners: radial jerk on a blend".
  static QString group(const SlowGroup& group);
  /// "turn 4.9° to 90°, median 5°"; "" for shapes without a measure.
  static QString measure(const SlowGroup& group);
  /// "3200 places, turn 4.9° to 90°, median 5°".
  static QString in_common(const SlowGroup& group);
  /// "−12.3 s", "+0.004 s"; "0" for nothing that digits show.
  static QString change(double seconds);
  /// "12.3 s": what a change spares.
  static QString gain(double seconds);
  /// "12.3 %" of something; "" of nothing.
  static QString percent(double part, double of);
};

}  // namespace feedscope::ui
