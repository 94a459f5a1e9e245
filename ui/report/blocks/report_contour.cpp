#include "ui/report/blocks/report_contour.h"

#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/base/ticks.h"
#include "core/base/units.h"
#include "ui/contour/contour_plot.h"
#include "ui/contour/contour_texts.h"
#include "ui/language/language.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/paper/html_table.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/report/scene_picture.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t max_error_places = 8;
constexpr std::size_t max_error_close_ups = 4;
constexpr std::size_t max_curves = 6;

/// Places with equal errors on paths of the same shape, such as the corners of a pocket.
struct SimilarErrors {
  ContourFinding worst;
  std::size_t count = 1;
};

bool similar(const ContourFinding& a, const ContourFinding& b) {
  constexpr double tolerance = 0.03;
  const auto near = [](double x, double y) { return std::abs(x - y) <= tolerance * std::max(x, y); };
  return a.spot.kind == b.spot.kind && a.spot.inside == b.spot.inside && near(a.place.error, b.place.error) &&
         near(a.spot.turn, b.spot.turn) && near(a.spot.radius, b.spot.radius) &&
         side_text(a.place) == side_text(b.place);
}

std::vector<SimilarErrors> worst_errors(const ReportInput& input, std::size_t most) {
  std::vector<SimilarErrors> kinds;
  for (const ContourFinding& finding : input.run().contour->worst) {
    const auto found =
        std::ranges::find_if(kinds, [&](const SimilarErrors& kind) { return similar(kind.worst, finding); });
    found != kinds.end() ? void(++found->count) : kinds.push_back({finding});
  }
  kinds.resize(std::min(kinds.size(), most));
  return kinds;
}

QString line_cell(const SimilarErrors& errors) {
  const QString line = html_text(line_text(errors.worst));
  return errors.count > 1 ? ReportWords::tr("%1 and %2 similar").arg(line).arg(errors.count - 1) : line;
}

/// Length of path on both sides of the place in a close-up [mm].
double shown_around(const ContourPlace& place) {
  constexpr double errors = 40;
  constexpr double least = 0.2;
  return std::max(errors * place.error, least);
}

/// Factor that enlarges the deviation to about a sixth of the half of the picture.
double enlargement(const ContourPlace& place) {
  constexpr double share = 6;
  constexpr double most = 1000;
  const double factor = shown_around(place) / (share * place.error);
  for (const double round : {500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.0}) {
    if (round <= std::min(factor, most)) {
      return round;
    }
  }
  return 1;
}

/// Top view for a flat place, the view of the whole path for others.
StandardView view_of(const Trajectory& trajectory, const std::array<double, 2>& times) {
  constexpr int samples = 50;
  Bounds bounds;
  for (int i = 0; i <= samples; ++i) {
    bounds.add(trajectory.state(times[0] + (times[1] - times[0]) * i / samples).position);
  }
  const Vec3 size = bounds.max - bounds.min;
  return size.z() <= 0.05 * std::max(size.x(), size.y()) ? StandardView::top : StandardView::iso;
}

ReportPicture close_up(const ReportInput& input, const ContourPlace& place) {
  const Trajectory& trajectory = *input.run().shown->run.trajectory;
  const double around = shown_around(place);
  const std::array<double, 2> times{trajectory.state_at_path(place.path_length - around).time,
                                    trajectory.state_at_path(place.path_length + around).time};
  ReportInput seen = input;
  seen.view = view_of(trajectory, times);
  seen.texts = without_line_names(std::move(seen.texts));
  seen.scene.stretch = {};
  seen.annotations = annotations_between(input, times[0], times[1]);
  seen.scene.colouring = Colouring::contour_error;
  seen.scene.exaggeration = enlargement(place);
  const QSizeF size = close_up_size();
  return {size, true, [seen, size, times, at = place.time](QPainter& painter, double pixel_ratio) {
            ScenePicture picture(seen, seen.current, ThemeKind::light);
            const SceneScale scale{pixel_ratio, 0.68};
            picture.prepare(size, scale);
            picture.scene().fit_times(times[0], times[1]);
            picture.scene().set_hover(picture.scene().drawn_at(at));
            picture.paint(painter, QRectF(QPointF(), size), scale);
          }};
}

}  // namespace

QString contour_histogram_block(const ReportInput& input, ReportPictures& pictures) {
  const ContourReport& current = *input.run().contour;
  if (current.worst.empty()) {
    return {};
  }
  auto curves = std::make_shared<ContourCurves>();
  curves->tolerance = current.tolerance;
  const auto add = [&](const ReportRun& run) {
    curves->runs.push_back({run.name, run.colour, run.contour->largest, run.contour->spread});
    curves->sides = curves->sides && run.contour->is_flat();
  };
  curves->sides = true;
  add(input.run());
  for (std::size_t i = 0; i < input.runs.size(); ++i) {
    if (i != input.current && curves->runs.size() < max_curves) {
      add(input.runs[i]);
    }
  }
  const QSizeF size(report_width, 230);
  const auto paint = [curves, size](QPainter& painter, double) {
    ContourPlot(*curves, QRectF(QPointF(), size), paper_font(10), theme_colours(QPalette(Qt::white)))
        .draw(painter);
  };
  const QString others =
      curves->runs.size() > 1 ? ReportWords::tr(", the other runs as outlines") : QString();
  return figure(pictures.add(QStringLiteral("contour"), {size, false, paint},
                             ReportWords::tr("Path length by contour error")),
                ReportWords::tr("Path length of %1 by contour error%2. %3 %4")
                    .arg(html_text(input.run().name), others, verdict_text(current).toHtmlEscaped(),
                         share_text(current, curves->sides).toHtmlEscaped()));
}

QString contour_places_block(const ReportInput& input) {
  const std::vector<int> widths =
      speaks_english() ? std::vector{4, 15, 8, 9, 6, 19, 14, 25} : std::vector{4, 14, 8, 10, 8, 17, 16, 23};
  HtmlTable table("rlrrlllr", widths);
  table.add_head({ReportWords::tr("No."), ReportWords::tr("Line"),
                  with_unit_of(ReportWords::tr("Error"), Dimension::error),
                  ReportWords::tr("Of tolerance [%]"), ReportWords::tr("Side"), ReportWords::tr("Where"),
                  with_unit_of(ReportWords::tr("Feed"), Dimension::feed),
                  with_unit_of(ReportWords::tr("At X, Y, Z"), Dimension::length)});
  int number = 0;
  for (const SimilarErrors& errors : worst_errors(input, max_error_places)) {
    const ContourFinding& found = errors.worst;
    const Vec3& at = found.place.position;
    constexpr double percent = 100;
    const bool has_tolerance = found.tolerance && *found.tolerance > 0;
    table.add({QString::number(++number), line_cell(errors), error_text(found.place.error),
               has_tolerance ? fixed(percent * found.place.error / *found.tolerance, 0) : QStringLiteral("–"),
               side_text(found.place), spot_text(found.spot).toHtmlEscaped(),
               ReportWords::tr("%1 of %2")
                   .arg(fixed(found.feed, Dimension::feed), fixed(found.programmed_feed, Dimension::feed)),
               ReportWords::tr("%1, %2, %3", "coordinates")
                   .arg(fixed(at.x(), Dimension::length), fixed(at.y(), Dimension::length),
                        fixed(at.z(), Dimension::length))});
  }
  return table.empty() ? QString() : table.html();
}

QString contour_place_views_block(const ReportInput& input, ReportPictures& pictures) {
  std::vector<std::pair<QString, QString>> shown;
  for (const SimilarErrors& errors : worst_errors(input, max_error_close_ups)) {
    const QString number = QString::number(shown.size() + 1);
    const double factor = enlargement(errors.worst.place);
    QString caption = ReportWords::tr("Place %1: line %2, %3")
                          .arg(number, line_cell(errors), error_amount_text(errors.worst.place.error));
    if (factor > 1) {
      caption += ReportWords::tr("; deviations exaggerated %1 times").arg(significant_number(factor, 4));
    }
    caption += '.';
    shown.emplace_back(
        pictures.add(QStringLiteral("error%1").arg(number), close_up(input, errors.worst.place),
                     ReportWords::tr("Close-up of contour error %1").arg(number)),
        caption);
  }
  return close_up_table(shown);
}

}  // namespace feedscope::ui
