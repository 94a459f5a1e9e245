#include "ui/report/question_figure.h"

#include <fmt/format.h>

#include <QPainter>
#include <algorithm>
#include <array>
#include <memory>

#include "core/analysis/circularity/program_circles.h"
#include "core/lessons/lesson_language.h"
#include "ui/circular/polar_plot.h"
#include "ui/paper/html_table.h"
#include "ui/report/charts_page.h"
#include "ui/report/scene_picture.h"

namespace feedscope::ui {

namespace {

constexpr double question_chart_height = 150;  // [1/96 inch]
constexpr double question_view_height = 210;
constexpr std::size_t most_circles = 4;
constexpr const char* causes_caption = "Limiting cause along the path";

/// A caption of a picture in the language of the lesson.
QString caption(const char* english, const Lesson& lesson, const std::string& what) {
  return html_text(fmt::format(fmt::runtime(lesson_word(english, lesson.language)), what));
}

/// Time of the run on the lines that a question watches [s]; the whole run without lines.
Interval times_of(const Measure& watch, const ShownRun& shown) {
  const Trajectory& trajectory = *shown.run.trajectory;
  if (watch.first_line == 0) {
    return {0, trajectory.duration()};
  }
  const double from = trajectory.time_of_line(watch.first_line);
  return {from, from + shown.line_times->of(watch.first_line, watch.last_line).time};
}

/// Half of the shorter one of the watched line and the next, on both sides of their corner.
Interval times_of_corner(const Measure& watch, const ShownRun& shown) {
  const Interval line = times_of(watch, shown);
  const double next = shown.line_times->of(watch.last_line + 1).time;
  const double half = std::min(line.width(), next) / 2;
  return {line.upper - half, line.upper + half};
}

bool watches_the_same(const Measure& one, const Measure& other) {
  return title_of(one) == title_of(other);
}

bool is_corner(const Measure& watch) {
  return watch.spec->key.starts_with("corner_feed");
}

bool is_deviation(const Measure& watch) {
  return watch.spec->key.starts_with("max_contour_error") ||
         watch.spec->quantity == QuantityId::actual_contour_error;
}

bool is_watched(const CircularTest& test, const Measure& watch) {
  return watch.first_line == 0 || std::ranges::any_of(test.passes, [&](const CirclePass& pass) {
           return pass.last_line >= watch.first_line && pass.first_line <= watch.last_line;
         });
}

/// The chart of the watched quantity, by ChartSpec::key; empty: none.
QString chart_of(const Measure& watch) {
  const std::string& unit = watch.spec->unit;
  for (const ChartSpec& chart : kinematic_chart_specs()) {
    const bool by_quantity =
        watch.spec->quantity && std::ranges::any_of(chart.curves, [&](const CurveSpec& curve) {
          return curve.quantity == *watch.spec->quantity;
        });
    if (by_quantity) {
      return chart.key;
    }
  }
  return unit == "m/s²"                        ? QStringLiteral("acceleration")
         : unit == "m/s³"                      ? QStringLiteral("jerk")
         : unit == "mm/min" || unit == "m/min" ? QStringLiteral("feed")
                                               : QString();
}

QString chart_figure(const Lesson& lesson, const Question& question, ReportInput seen, const QString& chart,
                     const QString& name, ReportPictures& pictures) {
  for (const ChartSpec& spec : kinematic_chart_specs()) {
    if (spec.key != chart) {
      seen.charts.hidden_charts.append(spec.key);
    }
  }
  if (question.watch.first_line > 0) {
    const Interval lines = times_of(question.watch, *seen.run().shown);
    constexpr double beside = 0.25;  // of their time, before and after
    const double room = beside * (lines.upper - lines.lower);
    seen.charts.time = Interval{std::max(0.0, lines.lower - room),
                                std::min(seen.run().shown->run.trajectory->duration(), lines.upper + room)};
  }
  const QSizeF size(report_width, question_chart_height);
  const auto paint = [seen, size](QPainter& painter, double pixel_ratio) {
    constexpr double shrunk = 0.84;
    ChartsPage page;
    page.set_runs(seen, seen.current);
    page.hide_title();
    page.set_background(Qt::white);
    page.prepare((size / shrunk).toSize(), std::max(1.0, shrunk * pixel_ratio));
    painter.scale(shrunk, shrunk);
    page.draw(painter, false);
  };
  const std::string watched = title_of(question.watch, lesson.language);
  return figure(pictures.add(name, {size, false, paint}, QString::fromStdString(watched)),
                caption("Before anything is changed: {}.", lesson, watched));
}

/// A time interval of the path in 3D with its surroundings, or the whole path.
QString view_figure(const Lesson& lesson, const Question& question, ReportInput seen,
                    const std::optional<Interval>& times, const QString& name, ReportPictures& pictures) {
  seen = without_other_runs(std::move(seen));
  seen.texts = without_line_names(std::move(seen.texts));  // they would lie over so low a picture
  if (times) {                                             // the rest is pale
    seen.scene.stretch = {PathStretch::charts, false};
    seen.charts.time = times;
    seen.scene.actual = seen.scene.actual && is_deviation(question.watch);
  }
  const QSizeF size(report_width, question_view_height);
  const auto paint = [seen, size, times](QPainter& painter, double pixel_ratio) {
    constexpr double text = 0.8;
    ScenePicture picture(seen, seen.current, ThemeKind::light);
    const SceneScale scale{pixel_ratio, text};
    picture.prepare(size, scale);
    if (times) {
      picture.scene().fit_times(times->lower, times->upper);
      constexpr double room = 0.8;
      picture.scene().zoom(room, {size.width() * pixel_ratio / 2, size.height() * pixel_ratio / 2});
    }
    picture.paint(painter, QRectF(QPointF(), size), scale);
  };
  const std::string watched = title_of(question.watch, lesson.language);
  return figure(pictures.add(name, {size, true, paint}, QString::fromStdString(watched)),
                times ? caption("Where to look: {}.", lesson, watched)
                      : caption(causes_caption, lesson, watched) + QLatin1Char('.'));
}

QString polar_figure(const Lesson& lesson, const Question& question, const ProgramCircles& circles,
                     const QString& name, ReportPictures& pictures) {
  constexpr double shrunk = 0.57;
  constexpr double heading = 40;  // without title and machine, which caption and first page have
  auto plot = std::make_shared<PolarPlot>();
  plot->setPalette(QPalette(Qt::white));
  plot->ensurePolished();
  std::vector<CircularTest> tests = circles.tests;
  std::erase_if(tests, [&](const CircularTest& test) { return !is_watched(test, question.watch); });
  tests.resize(std::min(tests.size(), most_circles));
  plot->set_tests({}, {}, std::move(tests));
  const QSizeF size(report_width, (plot->least_picture().height() - heading) * shrunk);
  const auto paint = [plot, size](QPainter& painter, double) {
    painter.scale(shrunk, shrunk);
    plot->draw(painter, QRectF(QPointF(), size / shrunk).adjusted(0, -heading, 0, 0), false);
  };
  const std::string watched = title_of(question.watch, lesson.language);
  return figure(pictures.add(name, {size, false, paint}, QString::fromStdString(watched)),
                caption("Before anything is changed: {}.", lesson, watched));
}

}  // namespace

bool is_straight(const SampledPath& path) {
  constexpr double min_share = 1e-3;
  Vec3 size = path.bounds.empty() ? Vec3::Zero() : Vec3(path.bounds.max - path.bounds.min);
  std::ranges::sort(size);
  return !(size[1] > min_share * size[2]);
}

QString question_figure(const Lesson& lesson, std::size_t index, const ReportInput& start, LessonRuns& runs,
                        ReportPictures& pictures, Progress* progress) {
  const Question& question = lesson.questions[index];
  const Measure& watch = question.watch;
  const auto name_of = [](auto number) { return QStringLiteral("question%1").arg(number + 1); };
  const auto shown_by = [&](const QString& picture, const char* english = "Already shown: {}") {
    return !pictures.all().contains(picture)
               ? QString()
               : QStringLiteral("<p class=\"caption\">%1%2</p>\n")
                     .arg(caption(english, lesson, title_of(watch, lesson.language)),
                          figure_reference(picture));
  };
  const auto earlier = std::ranges::find_if(lesson.questions, [&](const Question& one) {
    return one.with == question.with && watches_the_same(one.watch, watch);
  });
  const QString of_earlier = name_of(earlier - lesson.questions.begin());
  if (pictures.all().contains(of_earlier)) {
    return shown_by(of_earlier);
  }
  ReportInput seen = start;
  if (!question.with.empty()) {
    seen.runs = report_runs({make_shown(runs.run(question.with, progress))});
    seen.current = 0;
  }
  const QString name = name_of(index);
  const ShownRun& shown = *seen.run().shown;
  const bool straight = is_straight(*shown.samples);
  if (is_corner(watch) && !straight) {
    return view_figure(lesson, question, seen, times_of_corner(watch, shown), name, pictures);
  }
  if (is_deviation(watch)) {
    const ProgramCircles circles = program_circles(shown.run, progress);
    const auto watched = [&](const CircularTest& test) { return is_watched(test, watch); };
    if (std::ranges::any_of(circles.tests, watched)) {
      return polar_figure(lesson, question, circles, name, pictures);
    }
  }
  const QString chart = chart_of(watch);
  const bool in_first_charts = question.with.empty() && watch.first_line == 0;
  if (!chart.isEmpty()) {
    return in_first_charts ? shown_by(QStringLiteral("charts%1").arg(start.current))
                           : chart_figure(lesson, question, seen, chart, name, pictures);
  }
  if (straight) {
    return {};
  }
  if (watch.first_line > 0) {
    return view_figure(lesson, question, seen, times_of(watch, shown), name, pictures);
  }
  if (question.with.empty() && start.scene.colouring == Colouring::cause) {
    return shown_by(QStringLiteral("view"), causes_caption);
  }
  const auto same_run = std::ranges::find(lesson.questions, question.with, &Question::with);
  const QString causes = QStringLiteral("causes%1").arg(same_run - lesson.questions.begin() + 1);
  if (pictures.all().contains(causes)) {
    return shown_by(causes, causes_caption);
  }
  seen.scene.colouring = Colouring::cause;
  return view_figure(lesson, question, seen, std::nullopt, causes, pictures);
}

}  // namespace feedscope::ui
