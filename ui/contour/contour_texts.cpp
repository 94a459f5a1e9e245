#include "ui/contour/contour_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/units.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

namespace {

struct Contour {
  Q_DECLARE_TR_FUNCTIONS(Contour)
};

QString in_or_out(const ContourSpot& spot) {
  return spot.inside ? Contour::tr("inside") : Contour::tr("outside");
}

/// For the whole run.
QString tolerance_sentence(const ContourReport& report) {
  const auto [least, largest] = *report.tolerance;
  if (least != largest) {
    const bool kept = std::ranges::all_of(report.worst, [](const ContourFinding& finding) {
      return !finding.tolerance || keeps_tolerance(finding.place.error, *finding.tolerance);
    });
    return kept ? Contour::tr("The tolerances of the program, %1 to %2, are kept at all listed places.")
                      .arg(error_text(least), error_amount_text(largest))
                : Contour::tr("The tolerances of the program, %1 to %2, are exceeded at listed places.")
                      .arg(error_text(least), error_amount_text(largest));
  }
  if (keeps_tolerance(report.largest, largest)) {
    return Contour::tr("The contour tolerance of %1 is kept.").arg(error_amount_text(largest));
  }
  return Contour::tr("The contour tolerance of %1 is exceeded by %2.")
      .arg(error_amount_text(largest), error_amount_text(report.largest - largest));
}

}  // namespace

QString error_text(double mm) {
  const int decimals = mm >= 9.995e-3 ? 1 : mm >= 0.9995e-3 ? 2 : 3;
  return number_text(mm, Dimension::error, decimals);
}

QString error_amount_text(double mm) {
  return QStringLiteral("%1 %2").arg(error_text(mm), unit_of(Dimension::error));
}

QString line_text(const ContourFinding& finding) {
  const QString line = QString::number(finding.place.line);
  return finding.block.empty() ? line
                               : QStringLiteral("%1 (%2)").arg(line, QString::fromStdString(finding.block));
}

QString side_text(const ContourPlace& place) {
  constexpr double notable = 0.1;  // of the error
  if (std::abs(place.side) < notable * place.error) {
    return QStringLiteral("–");
  }
  return place.side > 0 ? Contour::tr("left") : Contour::tr("right");
}

QString spot_text(const ContourSpot& spot) {
  const QLocale locale;
  switch (spot.kind) {
    case ContourSpot::Kind::corner:
      return Contour::tr("Corner of %1°, %2")
          .arg(locale.toString(units::to_deg(spot.turn), 'f', spot.turn < 0.1 ? 1 : 0), in_or_out(spot));
    case ContourSpot::Kind::arc:
      return Contour::tr("Arc R %1, %2")
          .arg(significant_text(spot.radius, Dimension::length, 4), in_or_out(spot));
    case ContourSpot::Kind::line:
      break;
  }
  return Contour::tr("Line of %1").arg(significant_text(spot.length, Dimension::length, 3));
}

QString verdict_text(const ContourReport& report) {
  QStringList sentences;
  if (report.worst.empty()) {
    sentences.append(Contour::tr("The programmed path is followed exactly: no contour error."));
  } else {
    const ContourFinding& worst = report.worst.front();
    sentences.append(
        Contour::tr("Largest contour error %1, in line %2 at %3.")
            .arg(error_amount_text(report.largest), line_text(worst), clock_text(worst.place.time)));
    sentences.append(
        report.tolerance         ? tolerance_sentence(report)
        : !report.own_tolerances ? Contour::tr("No contour tolerance applies.")
        : report.program_tolerances
            ? Contour::tr("The control rounds each corner within P of G64 in the program, else within "
                          "the blend tolerance of the settings.")
            : Contour::tr("The control rounds each corner within the blend tolerance of the settings."));
  }
  if (report.rapids) {
    sentences.append(Contour::tr("Rapids, which do not count here, leave the programmed path by up to %1.")
                         .arg(error_amount_text(*report.rapids)));
  }
  return sentences.join(QLatin1Char(' '));
}

QString share_text(const ContourReport& report, bool sides) {
  if (report.worst.empty()) {
    return {};
  }
  const QString shares = Contour::tr("90 % of the path is within %1, 99 % within %2.")
                             .arg(error_amount_text(error_quantile(report.spread, 0.1)),
                                  error_amount_text(error_quantile(report.spread, 0.01)));
  constexpr double most_of_it = 0.9;
  const ContourPlace& worst = report.worst.front().place;
  return sides && std::abs(worst.side) < most_of_it * worst.error
             ? shares + QStringLiteral(" ") +
                   Contour::tr("The largest error is along Z, so left and right do not show it.")
             : shares;
}

double error_quantile(const ContourSpread& spread, double share) {
  const double whole = std::accumulate(spread.amount.begin(), spread.amount.end(), 0.0);
  double beyond = 0;
  std::size_t bin = spread.amount.size();
  while (bin > 0 && beyond + spread.amount[bin - 1] <= share * whole) {
    beyond += spread.amount[--bin];
  }
  return static_cast<double>(bin) * spread.step;
}

}  // namespace feedscope::ui
