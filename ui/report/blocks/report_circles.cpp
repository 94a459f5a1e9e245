#include "ui/report/blocks/report_circles.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/units.h"
#include "ui/circular/polar_plot.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"
#include "ui/language/shown_numbers.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t max_circle_rows = 24;
constexpr std::size_t max_circle_plots = 4;

QString deviation(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, Dimension::error, decimals) : QStringLiteral("–");
}

/// Common number of decimals of the deviations, so that the largest fits into its column.
int deviation_decimals(const ProgramCircles& circles) {
  constexpr double hundred = 0.1;  // [um]
  constexpr double thousand = 1;
  double largest = 0;
  for (const CircularTest& test : circles.tests) {
    for (const CirclePass& pass : test.passes) {
      const Circularity& found = pass.circularity;
      largest = std::max({largest, found.zone, std::abs(found.largest), std::abs(found.smallest)});
    }
  }
  return largest < hundred ? 2 : largest < thousand ? 1 : 0;
}

QString place(double value) {
  return fixed(value, Dimension::length);
}

QStringList row_of(int number, const CircularTest& test, const CirclePass& pass, int decimals) {
  const Circularity& found = pass.circularity;
  return {QString::number(number),
          circle_lines(pass),
          ReportWords::tr("%1, %2, %3", "coordinates")
              .arg(place(test.center.x()), place(test.center.y()), place(test.center.z())),
          QStringLiteral("%1 %2").arg(place(test.request.radius),
                                      QString::fromLatin1(info_of(test.request.plane).name.data())),
          ReportWords::tr("%1 of %2")
              .arg(fixed(pass.reached_feed, Dimension::feed), fixed(test.request.feed, Dimension::feed)),
          pass.counter_clockwise ? ReportWords::tr("ccw") : ReportWords::tr("cw"),
          deviation(found.zone, decimals),
          deviation(found.by_squares, decimals),
          deviation(found.largest, decimals),
          deviation(found.smallest, decimals),
          deviation(test.mean_deviation(pass), decimals),
          deviation(test.g_b(), decimals),
          deviation(test.d(), decimals)};
}

}  // namespace

ReportInput with_circles(ReportInput input, Progress* progress) {
  if (input.circles == nullptr) {
    input.circles = std::make_shared<const ProgramCircles>(program_circles(input.run().shown->run, progress));
  }
  return input;
}

QString circles_block(const ReportInput& input) {
  const ProgramCircles& circles = *input.circles;
  if (circles.tests.empty()) {
    return {};
  }
  const std::vector<int> widths = speaks_english() ? std::vector{4, 6, 18, 9, 12, 5, 6, 7, 7, 7, 7, 6, 6}
                                                   : std::vector{4, 6, 18, 9, 16, 6, 6, 6, 6, 6, 6, 6, 5};
  HtmlTable table("rlrrrlrrrrrrr", widths);
  const QString unit = QStringLiteral(" [%1]").arg(unit_of(Dimension::error));
  table.add_head({ReportWords::tr("No."), ReportWords::tr("Line"),
                  with_unit_of(ReportWords::tr("Centre X, Y, Z"), Dimension::length),
                  with_unit_of(ReportWords::tr("Radius"), Dimension::length),
                  with_unit_of(ReportWords::tr("Feed"), Dimension::feed), ReportWords::tr("Turn"),
                  QStringLiteral("G") + unit, QStringLiteral("G<sub>ls</sub>") + unit,
                  ReportWords::tr("F<sub>max</sub>") + unit, ReportWords::tr("F<sub>min</sub>") + unit,
                  ReportWords::tr("F<sub>mean</sub>") + unit, QStringLiteral("G(b)") + unit,
                  QStringLiteral("D") + unit});
  const int decimals = deviation_decimals(circles);
  std::size_t rows = 0;
  int number = 0;
  for (const CircularTest& test : circles.tests) {
    ++number;
    for (const CirclePass& pass : test.passes) {
      if (rows++ < max_circle_rows) {
        table.add(row_of(number, test, pass, decimals));
      }
    }
  }
  QString html = table.html();
  if (rows > max_circle_rows) {
    html += caption_paragraph(
        ReportWords::tr("The first %1 of %2 circles; “feedscope circular” lists all of them.")
            .arg(max_circle_rows)
            .arg(rows));
  }
  html += caption_paragraph(ReportWords::tr(
      "G: circular error, least radial separation of two concentric circles that hold the path; "
      "G<sub>ls</sub>: the same about the centre of the least-squares circle; F<sub>max</sub>, "
      "F<sub>min</sub>, F<sub>mean</sub>: largest, least and mean deviation from the programmed radius at "
      "the "
      "programmed centre; G(b), D: circular error of both directions together, and their mean radius less "
      "the "
      "programmed one, where the same circle is run in both at one feed. Centre and radius are those of the "
      "tool centre; ccw, cw: counter-clockwise, clockwise in the plane."));
  for (const Message& note : program_circle_notes(circles)) {
    html += caption_paragraph(html_text(in_language(note)));
  }
  return html;
}

QString circle_plots_block(const ReportInput& input, ReportPictures& pictures) {
  const ProgramCircles& circles = *input.circles;
  if (circles.tests.empty()) {
    return {};
  }
  constexpr double shrunk = 0.57;
  const std::size_t shown = std::min(circles.tests.size(), max_circle_plots);
  auto plot = std::make_shared<PolarPlot>();
  plot->setPalette(QPalette(Qt::white));
  plot->ensurePolished();
  plot->set_tests(ReportWords::tr("Circular test (ISO 230-4)"),
                  ReportWords::tr("%1, model %2")
                      .arg(QString::fromStdString(input.run().shown->run.setup.machine.name),
                           QString::fromStdString(input.run().shown->run.setup.model->info().id)),
                  {circles.tests.begin(), circles.tests.begin() + static_cast<std::ptrdiff_t>(shown)});
  const QSizeF size(report_width, plot->least_picture().height() * shrunk);
  const auto paint = [plot, size](QPainter& painter, double) {
    painter.scale(shrunk, shrunk);
    plot->draw(painter, QRectF(QPointF(), size / shrunk));
  };
  const QString which =
      shown < circles.tests.size()
          ? ReportWords::tr("the first %1 of %2 circles").arg(shown).arg(circles.tests.size())
          : ReportWords::tr("the circles");
  return figure(pictures.add(QStringLiteral("circles"), {size, false, paint},
                             ReportWords::tr("Polar plots of the circles of the program")),
                ReportWords::tr("Polar plots of %1 of %2 by the %3 path; radial deviations are enlarged.")
                    .arg(which, html_text(input.run().name),
                         circles.actual ? ReportWords::tr("actual") : ReportWords::tr("set")));
}

}  // namespace feedscope::ui
