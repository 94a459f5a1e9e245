#include "ui/program_text/line_time_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"

namespace feedscope::ui {

namespace {

struct LineTimeText {
  Q_DECLARE_TR_FUNCTIONS(LineTimeText)
};

}  // namespace

double heat_of(double time, double largest) {
  return time > 0 && largest > 0 ? std::min(std::cbrt(time / largest), 1.0) : 0;
}

QString line_time_text(const LineTimes& times, std::uint32_t first, std::uint32_t last) {
  const LineTime cost = times.of(first, last);
  if (cost.runs == 0) {
    return {};
  }
  const QLocale locale;
  constexpr double percent = 100;
  QStringList text;
  text.append(first == last
                  ? LineTimeText::tr("Line %1").arg(locale.toString(first))
                  : LineTimeText::tr("Lines %1 to %2").arg(locale.toString(first), locale.toString(last)));
  text.append(LineTimeText::tr("%1, %2 % of the cycle time")
                  .arg(clock_text(cost.time), locale.toString(percent * cost.time / times.total(), 'f', 2)));
  if (first == last && cost.runs > 1) {
    text.append(LineTimeText::tr("executed %1 times, %2 each on average")
                    .arg(locale.toString(static_cast<qulonglong>(cost.runs)),
                         clock_text(cost.time / static_cast<double>(cost.runs))));
  }
  if (cost.mean_feed() > 0) {
    text.append(LineTimeText::tr("mean feed %1").arg(amount_text(cost.mean_feed(), Dimension::feed)));
  }
  return text.join('\n');
}

}  // namespace feedscope::ui
