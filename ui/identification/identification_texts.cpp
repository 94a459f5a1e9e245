#include "ui/identification/identification_texts.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/identification/recordings.h"
#include "ui/identification/identification_outcome.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/signed_number.h"
#include "ui/language/significant.h"
#include "ui/language/texts.h"

namespace feedscope::ui {
namespace {

constexpr int digits = 4;

QString number(double value) {
  return significant_number(value, digits);
}

/// Number of decimals for one significant digit of an uncertainty, two where the first is 1.
int decimals_by(double uncertainty) {
  constexpr int most = 9;
  if (!(uncertainty > 0)) {
    return digits;
  }
  const double exponent = std::floor(std::log10(uncertainty));
  const bool begins_with_one = uncertainty < 2 * std::pow(10, exponent);
  return std::clamp(static_cast<int>(-exponent) + (begins_with_one ? 1 : 0), 0, most);
}

}  // namespace

QString IdentificationTexts::title(const FitParameter& parameter) {
  const QString unit = key_unit(parameter.unit).text;
  const QString name = setting_title(parameter.key);
  return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

QString IdentificationTexts::value(double value, const FitParameter& parameter) {
  return value > 0 ? number(value * key_unit(parameter.unit).factor) : QStringLiteral("–");
}

QString IdentificationTexts::found_value(const IdentifiedParameter& parameter) {
  const double factor = key_unit(parameter.parameter.unit).factor;
  if (!parameter.told) {
    return parameter.at_least ? tr("at least %1").arg(number(*parameter.at_least * factor)) : tr("not found");
  }
  return QLocale().toString(parameter.value * factor, 'f', decimals_by(parameter.uncertainty * factor));
}

QString IdentificationTexts::uncertainty(const IdentifiedParameter& parameter) {
  if (!parameter.told) {
    return QStringLiteral("–");
  }
  const double shown = parameter.uncertainty * key_unit(parameter.parameter.unit).factor;
  return QLocale().toString(shown, 'f', decimals_by(shown));
}

QString IdentificationTexts::found(const IdentifiedParameter& parameter) {
  const QString value = found_value(parameter);
  return parameter.told ? QStringLiteral("%1 ± %2").arg(value, uncertainty(parameter)) : value;
}

QString IdentificationTexts::explanation(const IdentifiedParameter& parameter, bool explains) {
  if (parameter.told) {
    return (is_drive_parameter(parameter.parameter)
                ? tr("With 95 % probability the true value is %1, if the drive is linear and both positions "
                     "are of the same instant.")
                : tr("With 95 % probability the true value is %1, if the control is of this model."))
        .arg(found(parameter));
  }
  QString reason = core_text(parameter.reason);
  if (!explains) {
    return reason;
  }
  if (parameter.value > 0 && parameter.value != parameter.start) {
    const QString unit = key_unit(parameter.parameter.unit).text;
    reason +=
        ' ' + tr("In use: %1.")
                  .arg(value(parameter.value, parameter.parameter) + (unit.isEmpty() ? "" : ' ' + unit));
  }
  const QString part = QString::fromStdString(parameter.told_by);
  if (part.isEmpty() &&
      (is_drive_parameter(parameter.parameter) || parameter.parameter.key == feed_override_key)) {
    return reason;
  }
  return reason + ' ' +
         (part.isEmpty() ? tr("No part of the test program would show this value.")
                         : tr("A recording of the test program tells it: part %1.").arg(part));
}

QString IdentificationTexts::judgement(const Identification& found) {
  const QString model = core_text(found.setup.model->info().title);
  if (found.explains) {
    return tr("The model %1 explains what was recorded.").arg(model);
  }
  const QString unexplained =
      tr("The model %1 does not explain what was recorded: it misses more than 5 % of "
         "the feed or 1 % of the time, so its numbers would say nothing of your machine.")
          .arg(model);
  QStringList held;
  for (const std::string& key : held_parameters(found)) {
    held.append(QString::fromStdString(key));
  }
  return held.isEmpty() ? unexplained
                        : unexplained + ' ' +
                              tr("Not looked for: %1. With these the model may explain it.")
                                  .arg(held.join(QStringLiteral(", ")));
}

QString IdentificationTexts::time_error(const Agreement& agreement) {
  return signed_number(100 * agreement.time_error(), 2);
}

QStringList IdentificationTexts::agreements(const IdentificationOutcome& outcome,
                                            const Identification& found) {
  QStringList lines;
  for (std::size_t i = 0; i < found.agreements.size(); ++i) {
    const Agreement& agreement = found.agreements[i];
    const QString times = tr("%1: %2 recorded, %3 simulated (%4 %)")
                              .arg(outcome.recordings[i].name, clock_text(agreement.measured_time),
                                   clock_text(agreement.simulated_time), time_error(agreement));
    lines.append(found.sections[i].empty() ? tr("%1; the feeds differ by %2 (rms).")
                                                 .arg(times, amount_text(agreement.feed_rms, Dimension::feed))
                                           : times + '.');
  }
  return lines;
}

QStringList IdentificationTexts::drives(const Identification& found) {
  QStringList lines;
  for (const DriveFit& drive : found.drives) {
    const QString axis(QLatin1Char(drive.axis));
    if (drive.samples == 0 || !(drive.following_error > 0)) {
      lines.append(tr("Drive of %1: not found.").arg(axis));
      continue;
    }
    if (drive.delay != 0) {
      lines.append(
          tr("Drive of %1: not found, the actual positions seem to be %2 ms later than the set ones.")
              .arg(axis, QLocale().toString(1e3 * drive.delay, 'f', 1)));
      continue;
    }
    const QString errors = tr("Drive of %1: following error %2 (rms), %3 of it unexplained")
                               .arg(axis, amount_text(drive.following_error, Dimension::error),
                                    amount_text(drive.left, Dimension::error));
    lines.append(drive.explains ? errors + '.' : tr("%1: too much to find its values.").arg(errors));
  }
  return lines;
}

QString IdentificationTexts::summary(const Identification& found) {
  std::vector<std::pair<QString, QStringList>> by_part;
  qsizetype told = 0;
  for (const IdentifiedParameter& one : found.parameters) {
    if (one.told) {
      ++told;
    } else if (!one.told_by.empty()) {
      const QString part = QString::fromStdString(one.told_by);
      auto known = std::ranges::find(by_part, part, &std::pair<QString, QStringList>::first);
      if (known == by_part.end()) {
        known = by_part.insert(known, {part, {}});
      }
      known->second.append(setting_title(one.parameter.key));
    }
  }
  QStringList lines{tr("Found: %1 of %2 values.").arg(told).arg(found.parameters.size())};
  if (told < static_cast<qsizetype>(found.parameters.size())) {
    lines.front() += ' ' + tr("The others keep the value that explains the recording as well.");
  }
  for (const auto& [part, titles] : by_part) {
    lines.append(
        tr("The part %1 of the test program would show: %2").arg(part, titles.join(QStringLiteral(", "))));
  }
  return lines.join(QStringLiteral("\n"));
}

QString IdentificationTexts::names(const IdentificationOutcome& outcome) {
  QStringList names;
  for (const UsedRecording& recording : outcome.recordings) {
    names.append(recording.name);
  }
  return names.join(QStringLiteral(", "));
}

}  // namespace feedscope::ui
