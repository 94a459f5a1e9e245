#include "ui/report/blocks/report_motion.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/analysis/contour/programmed_place.h"
#include "core/base/ticks.h"
#include "core/base/units.h"
#include "ui/language/shown_numbers.h"
#include "ui/report/blocks/feed_course.h"
#include "ui/report/blocks/report_decision.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/shared/plot_grid.h"
#include "ui/theme/fonts.h"
#include "ui/workbench/run_list.h"

namespace feedscope::ui {

namespace {

constexpr int motion_type = 10;
constexpr std::size_t most_runs_drawn = 8;
constexpr double motion_right = 18;  // half a label right of a plot [1/96 inch]
const GridLook motion_grid{QColor(0xe6, 0xe9, 0xec), QColor(0x9a, 0xa0, 0xa8), QColor(0x40, 0x46, 0x4d)};
const QColor motion_ink(0x22, 0x26, 0x2a);
const QColor programmed_ink(0x9a, 0xa0, 0xa8);

/// A curve in shown units.
struct MotionCurve {
  std::vector<QPointF> points;
  QPen pen;
};

/// A plot in shown units: its curves, title and ranges.
struct MotionPlot {
  QString title;
  QRectF place;
  double from = 0;
  double to = 1;
  double low = 0;
  double high = 1;
  std::vector<MotionCurve> curves;

  QPointF at(const QPointF& point) const {
    return {place.left() + (point.x() - from) / (to - from) * place.width(),
            place.bottom() - (point.y() - low) / (high - low) * place.height()};
  }
};

QPen run_pen(const ReportInput& input, std::size_t run) {
  QPen pen(input.runs[run].colour, 1.3);
  pen.setCapStyle(Qt::FlatCap);
  pen.setJoinStyle(Qt::RoundJoin);
  if (const QList<qreal> dashes = run_dashes(run); !dashes.isEmpty()) {
    pen.setDashPattern(dashes);
  }
  return pen;
}

/// The current run last, so that it stays visible.
std::vector<std::size_t> drawn_runs(const ReportInput& input) {
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < input.runs.size() && runs.size() + 1 < most_runs_drawn; ++i) {
    if (i != input.current && !input.runs[i].shown->run.trajectory->pieces().empty()) {
      runs.push_back(i);
    }
  }
  runs.push_back(input.current);
  return runs;
}

void paint_motion_plot(QPainter& painter, const MotionPlot& plot, bool labelled_below, bool labelled_left) {
  painter.setFont(paper_font(motion_type));
  PlotGrid grid(painter, plot.place, motion_grid);
  constexpr double row_room = 26;
  const Ticks rows = round_ticks(plot.low, plot.high, static_cast<int>(plot.place.height() / row_room));
  for (std::size_t i = 0; i < rows.values.size(); ++i) {
    grid.level(plot.at({plot.from, rows.values[i]}).y(), labelled_left ? tick_text(rows, i) : QString(),
               rows.values[i] == 0 ? GridLine::strong : GridLine::usual);
  }
  constexpr double column_room = 70;
  const Ticks columns =
      round_ticks(plot.from, plot.to, std::max(4, static_cast<int>(plot.place.width() / column_room)));
  for (std::size_t i = 0; i < columns.values.size(); ++i) {
    grid.upright(plot.at({columns.values[i], plot.low}).x(),
                 labelled_below ? tick_text(columns, i) : QString());
  }
  painter.save();
  painter.setClipRect(plot.place.adjusted(-1, -1, 1, 1));
  painter.setBrush(Qt::NoBrush);
  for (const MotionCurve& curve : plot.curves) {
    QPainterPath path;
    for (const QPointF& point : curve.points) {
      path.elementCount() == 0 ? path.moveTo(plot.at(point)) : path.lineTo(plot.at(point));
    }
    painter.setPen(curve.pen);
    painter.drawPath(path);
  }
  painter.restore();
  painter.setPen(motion_ink);
  const QFontMetricsF metrics(painter.font());
  painter.drawText(
      QPointF(plot.place.left() - (labelled_left ? 44 : 0), plot.place.top() - metrics.descent() - 3),
      plot.title);
}

/// Fits the range to the values of curves, with some room above.
void fit_motion(std::vector<MotionPlot*> plots, bool from_zero) {
  double low = from_zero ? 0 : 1e300;
  double high = -1e300;
  for (const MotionPlot* plot : plots) {
    for (const MotionCurve& curve : plot->curves) {
      for (const QPointF& point : curve.points) {
        low = std::min(low, point.y());
        high = std::max(high, point.y());
      }
    }
  }
  constexpr double room = 0.06;
  high = high > low ? high + room * (high - low) : low + 1;
  low = low < 0 ? low - room * (high - low) : low;
  for (MotionPlot* plot : plots) {
    plot->low = low;
    plot->high = high;
  }
}

/// Paints the legend of the runs in the top right corner of a plot.
void paint_motion_legend(QPainter& painter, const ReportInput& input, double right, double base) {
  painter.setFont(paper_font(motion_type));
  const QFontMetricsF metrics(painter.font());
  const auto entry = [&](const QString& text, const QPen& pen) {
    constexpr double sample = 22;
    right -= metrics.horizontalAdvance(text);
    painter.setPen(motion_ink);
    painter.drawText(QPointF(right, base), text);
    right -= sample + 4;
    painter.setPen(pen);
    painter.drawLine(QPointF(right, base - metrics.ascent() / 3),
                     QPointF(right + sample, base - metrics.ascent() / 3));
    right -= 12;
  };
  entry(ReportWords::tr("programmed"), QPen(programmed_ink, 1));
  std::vector<std::size_t> runs = drawn_runs(input);
  std::ranges::sort(runs, std::greater());
  if (input.runs.size() > 1) {
    for (const std::size_t run : runs) {
      entry(run_letter(run), run_pen(input, run));
    }
  }
}

/// The courses of the drawn runs.
struct FeedCourses {
  std::vector<std::size_t> runs;
  std::vector<FeedCourse> courses;
};

std::vector<QPointF> steps_of(const FeedCourse& course, const std::vector<double>& values, double factor) {
  std::vector<QPointF> points;
  const double part = in_shown_unit(course.length, Dimension::length) / static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    points.emplace_back(part * (static_cast<double>(i) + 0.5), values[i] * factor);
  }
  return points;
}

void paint_feed_courses(QPainter& painter, const QSizeF& size, const ReportInput& input,
                        const FeedCourses& shown) {
  constexpr double left = 52;
  constexpr double title = 18;
  constexpr double below = 34;
  const double feed_height = 0.62 * (size.height() - 2 * title - below);
  MotionPlot feed;
  feed.title = with_unit_of(ReportWords::tr("Mean feed"), Dimension::feed);
  feed.place = {left, title, size.width() - left - motion_right, feed_height};
  MotionPlot lost;
  lost.title = ReportWords::tr("Time lost so far [s]");
  const double lost_top = feed.place.bottom() + title + 6;
  lost.place = {left, lost_top, feed.place.width(), size.height() - below - lost_top};
  const double feed_factor = in_shown_unit(1, Dimension::feed);
  for (std::size_t i = 0; i < shown.runs.size(); ++i) {
    const FeedCourse& course = shown.courses[i];
    feed.to = lost.to = in_shown_unit(course.length, Dimension::length);
    if (i == 0) {
      feed.curves.push_back({steps_of(course, course.programmed, feed_factor), QPen(programmed_ink, 1)});
    }
    feed.curves.push_back({steps_of(course, course.feed, feed_factor), run_pen(input, shown.runs[i])});
    lost.curves.push_back({steps_of(course, course.lost, 1), run_pen(input, shown.runs[i])});
  }
  fit_motion({&feed}, true);
  fit_motion({&lost}, true);
  paint_motion_plot(painter, feed, false, true);
  paint_motion_plot(painter, lost, true, true);
  paint_motion_legend(painter, input, feed.place.right(), feed.place.top() - 5);
  painter.setPen(motion_ink);
  painter.drawText(QRectF(left, size.height() - 14, feed.place.width(), 14), Qt::AlignCenter,
                   with_unit_of(ReportWords::tr("Programmed path of feed motions"), Dimension::length));
}

/// A range of time around a place of the current run.
struct MotionWindow {
  SlowPlace place;
  double centre = 0;  ///< of the current run [s]
  double half = 0;    ///< [s]
};

/// Whether one of `places` overlaps `place`: groups of different causes may have the same worst place.
bool is_seen(const SlowPlace& place, const std::vector<SlowPlace>& places) {
  return std::ranges::any_of(
      places, [&](const SlowPlace& other) { return other.from < place.to && place.from < other.to; });
}

/// Feed motions only, as in the curves above: a rapid would determine the scale.
std::vector<MotionWindow> motion_windows(const ReportInput& input) {
  constexpr std::size_t most = 3;
  constexpr double least_half = 0.15;  // [s]
  constexpr double largest_half = 0.5;
  std::vector<SlowPlace> places;
  const std::vector<SlowGroup>& groups = input.time->slow.groups;
  for (std::size_t rank = 0; rank < SlowGroups::worst_places && places.size() < most; ++rank) {
    for (const SlowGroup& group : groups) {
      if (places.size() < most && rank < group.worst.size() && group.shape != PlaceShape::rapid &&
          !is_seen(group.worst[rank], places)) {
        places.push_back(group.worst[rank]);
      }
    }
  }
  std::vector<MotionWindow> windows;
  for (const SlowPlace& place : places) {
    windows.push_back(
        {place, place.slowest, std::clamp(0.75 * (place.to - place.from), least_half, largest_half)});
  }
  return windows;
}

enum class MotionRow { feed, acceleration, jerk };

/// Whether the acceleration of a run does not jump: the jerk between jumps is meaningless.
bool has_jerk(const ReportRun& run) {
  return run.shown->run.sources.limits_jerk;
}

/// Those that any of the drawn runs has.
std::vector<MotionRow> motion_rows(const ReportInput& input) {
  std::vector<MotionRow> rows{MotionRow::feed, MotionRow::acceleration};
  if (std::ranges::any_of(drawn_runs(input), [&](std::size_t run) { return has_jerk(input.runs[run]); })) {
    rows.push_back(MotionRow::jerk);
  }
  return rows;
}

double motion_value(const State& state, MotionRow row) {
  switch (row) {
    case MotionRow::feed:
      return in_shown_unit(state.speed, Dimension::feed);
    case MotionRow::acceleration:
      return in_shown_unit(state.acceleration.norm(), Dimension::acceleration);
    case MotionRow::jerk:
      break;
  }
  return in_shown_unit(state.jerk.norm(), Dimension::jerk);
}

QString motion_title(MotionRow row) {
  return row == MotionRow::feed ? with_unit_of(ReportWords::tr("Feed"), Dimension::feed)
         : row == MotionRow::acceleration
             ? with_unit_of(ReportWords::tr("Acceleration"), Dimension::acceleration)
             : with_unit_of(ReportWords::tr("Jerk"), Dimension::jerk);
}

/// The curves of the runs in a window, those of others at the same place of the program; a rapid divides a
/// curve.
std::vector<std::vector<MotionCurve>> window_curves(const ReportInput& input, const MotionWindow& window,
                                                    const std::vector<MotionRow>& rows) {
  constexpr int samples = 300;
  std::vector<std::vector<MotionCurve>> curves(rows.size());
  const ProgrammedPlace place = programmed_place(*input.run().shown->run.trajectory, window.centre);
  for (const std::size_t run : drawn_runs(input)) {
    const Trajectory& trajectory = *input.runs[run].shown->run.trajectory;
    const double centre = run == input.current ? window.centre : time_of(trajectory, place);
    const bool jerk = has_jerk(input.runs[run]);
    bool parted = true;
    for (int i = 0; i <= samples; ++i) {
      const double offset = window.half * (2.0 * i / samples - 1);
      if (centre + offset < 0 || centre + offset > trajectory.duration()) {
        continue;
      }
      const State state = trajectory.state(centre + offset);
      if (trajectory.is_rapid(state.element)) {
        parted = true;
        continue;
      }
      for (std::size_t row = 0; row < rows.size(); ++row) {
        if (rows[row] == MotionRow::jerk && !jerk) {
          continue;
        }
        if (parted) {
          curves[row].emplace_back().pen = run_pen(input, run);
        }
        curves[row].back().points.emplace_back(offset, motion_value(state, rows[row]));
      }
      parted = false;
    }
  }
  return curves;
}

void paint_motion_windows(QPainter& painter, const QSizeF& size, const ReportInput& input,
                          const std::vector<MotionWindow>& windows) {
  constexpr double left = 52;
  constexpr double gap = 30;  // keeps labels of neighbouring axes apart
  constexpr double head = 18;
  constexpr double title = 19;
  constexpr double below = 34;
  const double count = static_cast<double>(windows.size());
  const double width = (size.width() - left - motion_right - gap * (count - 1)) / count;
  const std::vector<MotionRow> rows = motion_rows(input);
  const auto row_count = static_cast<double>(rows.size());
  const double height = (size.height() - head - row_count * title - below) / row_count;
  std::vector<std::vector<MotionPlot>> plots(rows.size());
  for (std::size_t column = 0; column < windows.size(); ++column) {
    auto curves = window_curves(input, windows[column], rows);
    for (std::size_t row = 0; row < plots.size(); ++row) {
      MotionPlot& plot = plots[row].emplace_back();
      plot.title = column == 0 ? motion_title(rows[row]) : QString();
      plot.place = {left + static_cast<double>(column) * (width + gap),
                    head + title + static_cast<double>(row) * (height + title), width, height};
      plot.from = -windows[column].half;
      plot.to = windows[column].half;
      plot.curves = std::move(curves[row]);
    }
  }
  painter.setFont(paper_font(motion_type, true));
  painter.setPen(motion_ink);
  for (std::size_t column = 0; column < windows.size(); ++column) {
    painter.drawText(QRectF(plots[0][column].place.left(), 0, width, head), Qt::AlignLeft | Qt::AlignVCenter,
                     ReportWords::tr("Line %1").arg(windows[column].place.line));
  }
  for (std::size_t row = 0; row < plots.size(); ++row) {
    std::vector<MotionPlot*> same;
    for (MotionPlot& plot : plots[row]) {
      same.push_back(&plot);
    }
    fit_motion(same, true);
    for (std::size_t column = 0; column < plots[row].size(); ++column) {
      paint_motion_plot(painter, plots[row][column], row + 1 == plots.size(), column == 0);
    }
  }
  painter.setPen(motion_ink);
  painter.drawText(QRectF(left, size.height() - 14, size.width() - left - motion_right, 14), Qt::AlignCenter,
                   ReportWords::tr("Time from the slowest instant [s]"));
}

}  // namespace

QString feed_course_block(const ReportInput& input, ReportPictures& pictures) {
  constexpr std::size_t parts = 300;
  auto shown = std::make_shared<FeedCourses>();
  for (const std::size_t run : drawn_runs(input)) {
    FeedCourse course = feed_course(input.runs[run].shown->run, parts);
    if (course.length > 0) {
      shown->runs.push_back(run);
      shown->courses.push_back(std::move(course));
    }
  }
  if (shown->runs.empty()) {
    return {};
  }
  const auto make = [shown, input](const QSizeF& size) {
    return ReportPicture{size, false, [shown, input, size](QPainter& painter, double) {
                           paint_feed_courses(painter, size, input, *shown);
                         }};
  };
  return figure(
      pictures.add_elastic(QStringLiteral("feeds"), report_width, {make, 260, 420},
                           ReportWords::tr("Feed and time lost over the path length")),
      (input.runs.size() > 1
           ? ReportWords::tr(
                 "Feed of all runs, mean over each of %1 equal parts of the path, and the time lost against "
                 "the programmed feed. Rapids and pauses are left out.")
           : ReportWords::tr("Feed, mean over each of %1 equal parts of the path, and the time lost against "
                             "the programmed feed. Rapids and pauses are left out."))
          .arg(parts));
}

QString motion_windows_block(const ReportInput& input, ReportPictures& pictures) {
  const std::vector<MotionWindow> windows = input.run().shown->run.trajectory->pieces().empty()
                                                ? std::vector<MotionWindow>()
                                                : motion_windows(input);
  if (windows.empty()) {
    return {};
  }
  const auto make = [windows, input](const QSizeF& size) {
    return ReportPicture{size, false, [windows, input, size](QPainter& painter, double) {
                           paint_motion_windows(painter, size, input, windows);
                         }};
  };
  return figure(
      pictures.add_elastic(QStringLiteral("windows"), report_width, {make, 330, 460},
                           ReportWords::tr("Motion about the worst places")),
      input.runs.size() > 1
          ? ReportWords::tr(
                "Motion of the tool about the places of %1 that lose most; other runs where they are "
                "at the same place of the program. Rapids are left out.")
                .arg(lettered_name(input, input.current))
          : ReportWords::tr("Motion of the tool about the places that lose most. Rapids are left out."));
}

}  // namespace feedscope::ui
