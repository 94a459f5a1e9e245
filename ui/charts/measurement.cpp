#include "ui/charts/measurement.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/language/shown_numbers.h"

namespace feedscope::ui {
namespace {

struct Cursors {
  Q_DECLARE_TR_FUNCTIONS(Cursors)
};

}  // namespace

Measurement measure(const State& first, const State& second) {
  const double time = second.time - first.time;
  const double length = second.path_length - first.path_length;
  return {time, length, time != 0 ? length / time : 0, second.speed - first.speed};
}

QString text_of(const Measurement& between) {
  return Cursors::tr("A → B:   Δt %1 s   ·   Δs %2   ·   mean feed %3   ·   Δfeed %4")
      .arg(QLocale().toString(between.time, 'f', 4), amount_text(between.path_length, Dimension::length),
           amount_text(between.mean_feed, Dimension::feed), amount_text(between.feed, Dimension::feed));
}

}  // namespace feedscope::ui
