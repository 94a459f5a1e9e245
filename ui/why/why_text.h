#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/analysis/explanation/explanation.h"

namespace feedscope::ui {

/// Texts of the "Why here?" panel, in the language and with the numbers of the user.
class WhyText {
  Q_DECLARE_TR_FUNCTIONS(WhyText)

 public:
  /// "Radial jerk of axis X".
  static QString cause(Cause cause);
  /// One sentence with its numbers.
  static QString sentence(const Explanation& why);
  /// A sentence on a slower place ahead.
  static QString sentence(const SlowerPlace& ahead, const State& now);
  /// For a place that is slow by `cause`, with `why` = explain() at a time when that is active, or before.
  static QString sentence(Cause cause, const Explanation& why);
  /// Sentence if the drives make most of the contour error at an instant of `actual`; else "", also without
  /// drives (null).
  static QString drives(const ActualPath* actual, const State& state);
  /// The formula as rich text: symbols, then numbers and result; "" without one.
  static QString formula(const Reason& reason);
  /// "Tapie 2007, eq 10 and 11", or another source of the limit.
  static QString source(const Reason& reason);
  /// "2 008 mm/min".
  static QString speed(double value);
  /// With its display unit: "2.5 mm", "10 m/s³".
  static QString number(double value, Dimension dimension);

 private:
  static QString limit_sentence(const Reason& reason, const State& state);
  static QString stop_sentence(StopReason reason);
  static QString tolerance_sentence(const Reason& reason);
  static bool is_of_joints(const Reason& reason);
  static QString joint_sentence(const Reason& reason);
  static QString blend_sentence(const Reason& reason);
  static QString arc_sentence(const Reason& reason);
  static QString curve_sentence(const Reason& reason);
  static QString ramp_sentence(const Reason& reason, const State& state);
};

}  // namespace feedscope::ui
