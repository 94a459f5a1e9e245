#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/analysis/time/time_report.h"

namespace feedscope::ui {

/// Texts on the breakdown of time, in the language and with the numbers of the user.
class TimeTexts {
  Q_DECLARE_TR_FUNCTIONS(TimeTexts)

 public:
  /// Rich text in two or three sentences: cycle time against programmed time, the largest loss, and the
  /// number of refused lines. `report`: on `run`, which is not refused.
  static QString conclusion(const TimeReport& report, const Run& run);
  /// Reason why a refused run has no cycle time.
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
  /// "−12.3 s", "+0.004 s"; "0" if it rounds to zero.
  static QString change(double seconds);
  /// "12.3 s": the time that a change saves.
  static QString gain(double seconds);
  /// "12.3 %" of `of`; "" if that is 0.
  static QString percent(double part, double of);
};

}  // namespace feedscope::ui
