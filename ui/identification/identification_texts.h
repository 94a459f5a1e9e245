#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>

#include "core/identification/identify.h"

namespace feedscope::ui {

struct IdentificationOutcome;

/// Texts and numbers of identification results.
class IdentificationTexts {
  Q_DECLARE_TR_FUNCTIONS(IdentificationTexts)

 public:
  /// "X Jerk [m/s³]".
  static QString title(const FitParameter& parameter);
  /// A number in the unit of its title; "–" for none, which is 0.
  static QString value(double value, const FitParameter& parameter);
  /// "1.300 ± 0.012", "at least 9.6", or the text for a number that is not identifiable.
  static QString found(const IdentifiedParameter& parameter);
  /// The reason why a number is not identifiable and what would make it so; for an identified one the meaning
  /// of its uncertainty.
  static QString explanation(const IdentifiedParameter& parameter, bool explains);
  /// The value without its uncertainty: "1.300", "at least 9.6", or the text for a number that is not
  /// identifiable.
  static QString found_value(const IdentifiedParameter& parameter);
  /// "0.012"; "–" for a number that is not identifiable.
  static QString uncertainty(const IdentifiedParameter& parameter);
  /// Whether the model explains the recordings.
  static QString judgement(const Identification& found);
  /// Times and feeds of each recording, one line each.
  static QStringList agreements(const IdentificationOutcome& outcome, const Identification& found);
  /// The part of the following errors that the fitted drives explain, one line each.
  static QStringList drives(const Identification& found);
  /// "+0.12", without the percent sign.
  static QString time_error(const Agreement& agreement);
  /// Number of identified parameters, and the parts of the test program that would identify how many of the
  /// others.
  static QString summary(const Identification& found);
  /// Names of the recordings, separated by commas.
  static QString names(const IdentificationOutcome& outcome);
};

}  // namespace feedscope::ui
