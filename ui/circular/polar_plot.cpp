#include "ui/circular/polar_plot.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/ticks.h"
#include "ui/language/shown_numbers.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"

namespace feedscope::ui {
namespace {

constexpr int text_size = 12;
constexpr int title_size = 15;
constexpr double margin = 14;
constexpr double gap = 18;
constexpr int divisions = 4;             // of the grid on each side of the nominal circle
constexpr double nominal_share = 0.6;    // of the plot's radius; the rest is for deviations
constexpr double least_division = 1e-4;  // [mm]
constexpr double full_turn = 2 * std::numbers::pi;

QFont sized(QFont font, int pixels, bool bold = false) {
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

/// Point at an angle; screen ordinates point down, angles count upwards.
QPointF on_circle(const QPointF& center, double radius, double angle) {
  return center + radius * QPointF(std::cos(angle), -std::sin(angle));
}

double largest_deviation(const CircularTest& test) {
  double largest = 0;
  for (const CirclePass& pass : test.passes) {
    largest = std::max({largest, std::abs(pass.circularity.largest), std::abs(pass.circularity.smallest)});
  }
  return largest;
}

QColor colour_of(const CirclePass& pass, const QPalette& palette) {
  const ThemeColours& colours = theme_colours(palette);
  return pass.counter_clockwise ? colours.path : colours.across;
}

/// A pass of any test in this direction; null: none.
const CirclePass* pass_in(const std::vector<CircularTest>& tests, bool counter_clockwise) {
  for (const CircularTest& test : tests) {
    for (const CirclePass& pass : test.passes) {
      if (pass.counter_clockwise == counter_clockwise) {
        return &pass;
      }
    }
  }
  return nullptr;
}

/// No minus sign before a value that is shown as 0.
QString amount(double value) {
  constexpr double shown_as_zero = 5e-5;  // [mm]
  return amount_text(std::abs(value) < shown_as_zero ? 0 : value, Dimension::error);
}

}  // namespace

/// Places of the parts of one plot.
struct PolarPlot::Frame {
  QPointF center;
  double radius = 0;    ///< of the nominal circle [pixels]
  double division = 0;  ///< distance of two circles of the grid [pixels]
};

QStringList circular_values(const CircularTest& test) {
  QStringList lines;
  for (const CirclePass& pass : test.passes) {
    const Circularity& found = pass.circularity;
    lines.append(
        PolarPlot::tr("%1: G %2 (least squares %3), F_max %4, F_min %5")
            .arg(pass.counter_clockwise ? PolarPlot::tr("counter-clockwise") : PolarPlot::tr("clockwise"),
                 amount(found.zone), amount(found.by_squares), amount(found.largest),
                 amount(found.smallest)));
  }
  if (test.both) {
    lines.append(PolarPlot::tr("both directions: G(b) %1, D %2").arg(amount(*test.g_b()), amount(*test.d())));
  } else if (!test.passes.empty()) {
    lines.append(PolarPlot::tr("mean radial deviation %1").arg(amount(test.mean_deviation(test.passes[0]))));
  }
  return lines;
}

QString circle_lines(const CirclePass& pass) {
  return pass.first_line == pass.last_line
             ? QString::number(pass.first_line)
             : QStringLiteral("%1–%2").arg(QString::number(pass.first_line), QString::number(pass.last_line));
}

QString circular_heading(const CircularTest& test) {
  const QString circle = PolarPlot::tr("R %1, %2, %3")
                             .arg(significant_text(test.request.radius, Dimension::length, 6),
                                  amount_text(test.request.feed, Dimension::feed, 0),
                                  QString::fromLatin1(info_of(test.request.plane).name.data()));
  if (!test.of_program()) {
    return circle;
  }
  QStringList lines;
  for (const CirclePass& pass : test.passes) {
    lines.append(circle_lines(pass));
  }
  return PolarPlot::tr("Line %1: %2").arg(lines.join(QStringLiteral(", ")), circle);
}

PolarPlot::PolarPlot(QWidget* parent) : QWidget(parent) {
  setFont(sized(font(), text_size));
}

void PolarPlot::set_tests(const QString& title, const QString& details, std::vector<CircularTest> tests) {
  title_ = title;
  details_ = details;
  tests_ = std::move(tests);
  double largest = 0;
  for (const CircularTest& test : tests_) {
    largest = std::max(largest, largest_deviation(test));
  }
  division_ = round_up_125(std::max(largest / divisions, least_division));
  update();
}

void PolarPlot::set_hint(const QString& hint) {
  hint_ = hint;
  update();
}

int PolarPlot::columns() const {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tests_.size())))));
}

QSize PolarPlot::minimumSizeHint() const {
  return {320, 200};
}

QSize PolarPlot::least_picture() const {
  const int rows = (static_cast<int>(tests_.size()) + columns() - 1) / columns();
  return {360 * columns(), 120 + 380 * std::max(rows, 1)};
}

QSize PolarPlot::sizeHint() const {
  constexpr int usual_width = 560;
  const int rows = (static_cast<int>(tests_.size()) + columns() - 1) / columns();
  double widest = 0;  // of the values below a plot, which would be cut off
  for (const CircularTest& test : tests_) {
    for (const QString& value : circular_values(test)) {
      widest = std::max(widest, QFontMetricsF(font()).horizontalAdvance(value) + 2 * margin);
    }
  }
  return {std::max(usual_width, static_cast<int>(std::ceil(widest))) * columns(),
          120 + 560 * std::max(rows, 1)};
}

void PolarPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter, rect(), values_shown_);
}

void PolarPlot::show_values(bool shown) {
  values_shown_ = shown;
  update();
}

void PolarPlot::draw(QPainter& painter, const QRectF& area, bool values) const {
  const ThemeColours& colours = theme_colours(palette());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, colours.plot);
  painter.setPen(tests_.empty() ? colours.muted : colours.text);
  if (tests_.empty()) {
    painter.setFont(font());
    painter.drawText(area.adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                     hint_);
    return;
  }
  const QFont bold = sized(font(), title_size, true);
  const double head = QFontMetricsF(bold).height();
  const double line = QFontMetricsF(font()).height();
  painter.setFont(bold);
  painter.drawText(QRectF(area.left() + margin, area.top() + margin, area.width() - 2 * margin, head),
                   Qt::AlignLeft | Qt::AlignVCenter, title_);
  painter.setFont(font());
  painter.drawText(QRectF(area.left() + margin, area.top() + margin + head, area.width() - 2 * margin, line),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetricsF(font()).elidedText(details_, Qt::ElideRight, area.width() - 2 * margin));
  const double legend = draw_legend(
      painter,
      QRectF(area.left() + margin, area.top() + margin + head + line + 4, area.width() - 2 * margin, line));
  const double top = legend + gap;
  const int across = columns();
  const int rows = (static_cast<int>(tests_.size()) + across - 1) / across;
  const double width = (area.width() - 2 * margin - (across - 1) * gap) / across;
  const double height = (area.bottom() - margin - top - (rows - 1) * gap) / rows;
  for (std::size_t i = 0; i < tests_.size(); ++i) {
    const auto column = static_cast<int>(i) % across;
    const auto row = static_cast<int>(i) / across;
    draw_test(
        painter,
        QRectF(area.left() + margin + column * (width + gap), top + row * (height + gap), width, height),
        tests_[i], values ? circular_values(tests_[i]) : QStringList());
  }
}

double PolarPlot::draw_legend(QPainter& painter, const QRectF& first_line) const {
  constexpr double sample = 24;
  constexpr double text_at = 30;
  const QFontMetricsF metrics(font());
  QRectF line = first_line;
  double x = line.left();
  const auto place = [&](double width) {  // in the next line when this one is full
    if (x > line.left() && x + width > line.right()) {
      line.translate(0, line.height());
      x = line.left();
    }
  };
  for (const bool counter_clockwise : {true, false}) {
    const CirclePass* const pass = pass_in(tests_, counter_clockwise);
    if (pass == nullptr) {
      continue;
    }
    const QString text = counter_clockwise ? tr("counter-clockwise") : tr("clockwise");
    const double width = text_at + metrics.horizontalAdvance(text);
    place(width);
    painter.setPen(
        QPen(colour_of(*pass, palette()), line_pixels(2), counter_clockwise ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(QPointF(x, line.center().y()), QPointF(x + sample, line.center().y()));
    painter.setPen(theme_colours(palette()).text);
    painter.drawText(QPointF(x + text_at, line.top() + metrics.ascent()), text);
    x += width + gap;
  }
  const QString division = tr("%1 a division").arg(significant_text(division_, Dimension::error, 3));
  place(metrics.horizontalAdvance(division));
  painter.drawText(QPointF(x, line.top() + metrics.ascent()), division);
  return line.bottom();
}

void PolarPlot::draw_test(QPainter& painter, const QRectF& cell, const CircularTest& test,
                          const QStringList& values) const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  const QString heading = circular_heading(test);
  double widest = QFontMetricsF(sized(font(), text_size, true)).horizontalAdvance(heading);
  for (const QString& value : values) {
    widest = std::max(widest, metrics.horizontalAdvance(value));
  }
  const double rows = line * static_cast<double>(values.size());
  // The values go below the plot, or to its right if there is more room.
  const bool beside = !values.isEmpty() && cell.width() - cell.height() > widest + gap;
  const QRectF plot = beside ? QRectF(cell.left(), cell.top(), cell.height(), cell.height())
                             : cell.adjusted(0, line + 4, 0, -rows - 4);
  const QRectF texts =
      beside ? QRectF(plot.right() + gap, cell.top(), cell.right() - plot.right() - gap, cell.height())
             : QRectF(cell.left(), cell.bottom() - rows, cell.width(), rows);
  const Qt::Alignment side = beside ? Qt::AlignLeft : Qt::AlignHCenter;
  painter.setPen(theme_colours(palette()).text);
  painter.setFont(sized(font(), text_size, true));
  painter.drawText(beside ? texts : cell, static_cast<int>(side | Qt::AlignTop), heading);
  painter.setFont(font());
  const double outer = std::min(plot.width(), plot.height()) / 2 - line;
  Frame frame;
  frame.center = plot.center();
  frame.radius = nominal_share * outer;
  frame.division = (1 - nominal_share) * outer / divisions;
  draw_grid(painter, frame, test);
  for (const CirclePass& pass : test.passes) {
    draw_pass(painter, frame, test, pass);
  }
  draw_start(painter, frame, test);
  painter.setPen(theme_colours(palette()).text);
  const double first = beside ? texts.top() + line + 4 : texts.top();
  for (qsizetype i = 0; i < values.size(); ++i) {
    painter.drawText(QRectF(texts.left(), first + static_cast<double>(i) * line, texts.width(), line),
                     static_cast<int>(side), metrics.elidedText(values[i], Qt::ElideRight, texts.width()));
  }
}

void PolarPlot::draw_grid(QPainter& painter, const Frame& frame, const CircularTest& test) const {
  const ThemeColours& colours = theme_colours(palette());
  painter.setBrush(Qt::NoBrush);
  for (int i = -divisions; i <= divisions; ++i) {
    const double radius = frame.radius + i * frame.division;
    painter.setPen(i == 0 ? QPen(colours.frame, 1.6) : QPen(colours.grid, 1));
    painter.drawEllipse(frame.center, radius, radius);
  }
  const PlaneInfo& plane = info_of(test.request.plane);
  const double outer = frame.radius + divisions * frame.division;
  const double line = QFontMetricsF(font()).height();
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * full_turn / 4;
    painter.setPen(QPen(colours.grid, 1));
    painter.drawLine(on_circle(frame.center, frame.radius - divisions * frame.division, angle),
                     on_circle(frame.center, outer, angle));
    painter.setPen(colours.muted);
    const QPointF at = on_circle(frame.center, outer + 0.6 * line, angle);
    const char axis = quarter % 2 == 0 ? plane.first : plane.second;
    painter.drawText(
        QRectF(at.x() - line, at.y() - line / 2, 2 * line, line), Qt::AlignCenter,
        QStringLiteral("%1%2").arg(QChar(axis)).arg(quarter < 2 ? QLatin1Char('+') : QChar(0x2212)));
  }
}

void PolarPlot::draw_pass(QPainter& painter, const Frame& frame, const CircularTest& test,
                          const CirclePass& pass) const {
  QPolygonF path;
  path.reserve(static_cast<qsizetype>(pass.places.size()));
  for (const Eigen::Vector2d& place : pass.places) {
    const double deviation = (place.norm() - test.request.radius) / division_ * frame.division;
    path.append(on_circle(frame.center, frame.radius + deviation, std::atan2(place.y(), place.x())));
  }
  painter.setPen(QPen(colour_of(pass, palette()), line_pixels(1.8),
                      pass.counter_clockwise ? Qt::SolidLine : Qt::DashLine));
  painter.drawPolyline(path);
}

/// Draws a dot at the start of the circle, and an arrow for each direction along the nominal circle.
void PolarPlot::draw_start(QPainter& painter, const Frame& frame, const CircularTest& test) const {
  const double inner = frame.radius - (divisions + 0.5) * frame.division;
  constexpr double reach = 0.9;  // [rad]
  constexpr double head = 6;     // [pixels]
  for (const CirclePass& pass : test.passes) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_colours(palette()).text);
    painter.drawEllipse(on_circle(frame.center, frame.radius, pass.start), 3.5, 3.5);
    const double turn = pass.counter_clockwise ? 1 : -1;
    const double radius = inner - (pass.counter_clockwise ? 0 : 2 * head);
    if (radius < 2 * head) {
      continue;
    }
    const QRectF box(frame.center.x() - radius, frame.center.y() - radius, 2 * radius, 2 * radius);
    constexpr double sixteenth_degrees = 16 * 360 / full_turn;
    painter.setPen(QPen(colour_of(pass, palette()), line_pixels(1.6)));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(box, static_cast<int>(pass.start * sixteenth_degrees),
                    static_cast<int>(turn * reach * sixteenth_degrees));
    const double angle = pass.start + turn * reach;
    const QPointF tip = on_circle(frame.center, radius, angle);
    for (const double side : {0.4, -0.4}) {
      const double back = angle - turn * full_turn / 4 + side;
      painter.drawLine(tip, tip + head * QPointF(std::cos(back), -std::sin(back)));
    }
  }
}

}  // namespace feedscope::ui
