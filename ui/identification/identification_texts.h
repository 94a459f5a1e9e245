#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>

#include "core/identification/identify.h"

namespace feedscope::ui {

struct IdentificationOutcome;

/// Words and numbers of what was identified.
class IdentificationTexts {
  Q_DECLARE_TR_FUNCTIONS(IdentificationTexts)

 public:
  /// "X Jerk [m/s³]".
  static QString title(const FitParameter& parameter);
  /// A number in the unit of its title; "–" for none, which is 0.
  static QString value(double value, const FitParameter& parameter);
  /// "1.300 ± 0.012", "at least 9.6", "not told".
  static QString found(const IdentifiedParameter& parameter);
  /// Why it is not told and what would tell it; of one that is told what its uncertainty says.
  static QString explanation(const IdentifiedParameter& parameter, bool explains);
  /// The value that was found alone: "1.300", "at least 9.6", "not told".
  static QString found_value(const IdentifiedParameter& parameter);
  /// "0.012"; "–" for one that is not told.
  static QString uncertainty(const IdentifiedParameter& parameter);
  /// Whether the model explains what was recorded.
  static QString judgement(const Identification& found);
  /// Times and feeds of each recording, a line each.
  static QStringList agreements(const IdentificationOutcome& outcome, const Identification& found);
  /// What the drives that were looked for explain of the following errors, a line each.
  static QStringList drives(const Identification& found);
  /// "+0.12", without the sign of percent.
  static QString time_error(const Agreement& agreement);
  /// "3 of 14 numbers are told", and which parts of the test program would tell how many of the others.
  static QString summary(const Identification& found);
  /// Of the recordings, with commas.
  static QString names(const IdentificationOutcome& outcome);
};

}  // namespace feedscope::ui
