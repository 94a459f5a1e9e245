#include "ui/report/report_pictures.h"

#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "core/analysis/time/ruled_instant.h"
#include "core/base/units.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"
#include "ui/paper/html_table.h"
#include "ui/paper/picture_file.h"
#include "ui/report/charts_page.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_tables.h"
#include "ui/report/report_words.h"
#include "ui/report/scene_picture.h"
#include "ui/runs/comparison_chart.h"
#include "ui/scene/colourings.h"
#include "ui/why/why_text.h"

namespace feedscope::ui {

namespace {

constexpr std::size_t max_places = 8;  // in the table
constexpr std::size_t max_close_ups = 6;
constexpr std::size_t max_charts = 6;
constexpr int close_ups_a_row = 2;
// Marks that with_figure_numbers() replaces by numbers: of a figure before its caption, in its anchor, of
// another figure.
const QString figure_mark(QChar(0xe000));
const QString anchor_mark(QChar(0xe001));
const QString reference_mark(QChar(0xe002));
constexpr double view_height = 400;  // [1/96 inch]

/// The current run in 3D. `seen`: the input, reduced to its visible parts.
ReportPicture scene_picture(const ReportInput& seen, const QSizeF& size) {
  return {size, true, [seen, size](QPainter& painter, double pixel_ratio) {
            ScenePicture(seen, seen.current, ThemeKind::light)
                .paint(painter, QRectF(QPointF(), size), {pixel_ratio, 0.8});
          }};
}

/// Paints paths of many points as rasters: as vectors they would make the file many times larger.
void paint_lightly(ScenePicture& picture, QPainter& painter, const ReportInput& seen, const QSizeF& size,
                   const SceneScale& scale) {
  constexpr std::size_t most_points = 5000;
  if (seen.run().shown->samples->times.size() <= most_points) {
    picture.paint(painter, QRectF(QPointF(), size), scale);
    return;
  }
  QImage image((size * scale.pixel_ratio).toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter pixels;
  begin_units(pixels, image, scale.pixel_ratio);
  picture.paint(pixels, QRectF(QPointF(), size), scale);
  pixels.end();
  image.setDevicePixelRatio(1);
  painter.drawImage(QRectF(QPointF(), size), image);
}

/// Places that lose time in a similar way, such as the turns of a pocket.
struct SimilarPlaces {
  SlowPlace worst;
  std::size_t count = 0;
  double loss = 0;  ///< of all of them [s]
};

bool similar(const SlowPlace& a, const SlowPlace& b) {
  constexpr double tolerance = 0.03;
  const auto near = [](double x, double y) { return std::abs(x - y) <= tolerance * std::max(x, y); };
  return a.cause == b.cause && near(a.loss, b.loss) && near(a.feed, b.feed) &&
         near(a.programmed_feed, b.programmed_feed);
}

/// Groups with the largest loss together, the worst first.
std::vector<SimilarPlaces> worst_places(const ReportInput& input, std::size_t most) {
  constexpr std::size_t max_kinds = 200;  // distinguished; the others lose less
  std::vector<SlowPlace> places = input.run().shown->slow_places->places;
  std::ranges::stable_sort(places, std::greater(), &SlowPlace::loss);
  std::erase_if(places, [](const SlowPlace& place) { return !(place.loss > 0); });
  std::vector<SimilarPlaces> kinds;
  for (const SlowPlace& place : places) {
    const auto found =
        std::ranges::find_if(kinds, [&](const SimilarPlaces& kind) { return similar(kind.worst, place); });
    if (found != kinds.end()) {
      ++found->count;
      found->loss += place.loss;
    } else if (kinds.size() < max_kinds) {
      kinds.push_back({place, 1, place.loss});
    }
  }
  std::ranges::stable_sort(kinds, std::greater(), &SimilarPlaces::loss);
  kinds.resize(std::min(kinds.size(), most));
  return kinds;
}

QString lines_text(const SimilarPlaces& places) {
  const SlowPlace& place = places.worst;
  const QString lines = place.first_line == place.last_line
                            ? QString::number(place.first_line)
                            : QStringLiteral("%1 – %2").arg(place.first_line).arg(place.last_line);
  return places.count > 1 ? ReportWords::tr("%1 and %2 similar").arg(lines).arg(places.count - 1) : lines;
}

/// Top view for a flat place, the view of the whole path for others.
StandardView view_of(const Run& run, const SlowPlace& place) {
  constexpr int samples = 50;
  Bounds bounds;
  for (int i = 0; i <= samples; ++i) {
    bounds.add(run.trajectory->state(place.from + (place.to - place.from) * i / samples).position);
  }
  const Vec3 size = bounds.max - bounds.min;
  return size.z() <= 0.05 * std::max(size.x(), size.y()) ? StandardView::top : StandardView::iso;
}

}  // namespace

ReportPicture close_up(const ReportInput& input, const SlowPlace& place, const QSizeF& size) {
  return {size, true, [seen = at_place(input, place), size, place](QPainter& painter, double pixel_ratio) {
            const SceneScale scale{pixel_ratio, 0.68};
            ScenePicture picture(seen, seen.current, ThemeKind::light);
            show_place(picture, place, size, scale);
            paint_lightly(picture, painter, seen, size, scale);
          }};
}

SceneTexts without_line_names(SceneTexts texts) {
  for (std::string* name : {&texts.programmed, &texts.rapid, &texts.executed, &texts.curve, &texts.blend,
                            &texts.tool_axis, &texts.start}) {
    name->clear();
  }
  return texts;
}

ReportInput at_place(ReportInput input, const SlowPlace& place) {
  const Run& run = input.run().shown->run;
  const bool is_rapid = run.trajectory->is_rapid(run.trajectory->state((place.from + place.to) / 2).element);
  input.view = view_of(run, place);
  input.texts = without_line_names(std::move(input.texts));
  input.scene.stretch = {};
  input.annotations = annotations_between(input, place.from, place.to);
  input.scene.colouring = Colouring::feed;
  input.scene.exaggeration = 1;
  input.scene.rapids = input.scene.rapids || is_rapid;
  input.scene.all_rapids = is_rapid;
  return input;
}

void show_place(ScenePicture& picture, const SlowPlace& place, const QSizeF& size, const SceneScale& scale) {
  picture.scene().set_strip(true);
  picture.prepare(size, scale);
  picture.scene().fit_times(place.from, place.to);
  const QSizeF pixels = size * scale.pixel_ratio;
  double top = 0;  // of the area between the strips
  double bottom = pixels.height();
  for (const auto& [corner, opposite] : picture.scene().covered()) {
    const bool is_strip = opposite[0] - corner[0] >= pixels.width() - 1;
    top = is_strip && corner[1] <= 0 ? opposite[1] : top;
    bottom = is_strip && corner[1] > 0 ? corner[1] : bottom;
  }
  picture.scene().zoom(0.7, {pixels.width() / 2, (top + bottom) / 2});
  picture.scene().set_highlight(std::array{place.from, place.to});
  picture.scene().set_hover(picture.scene().drawn_at(place.slowest));
}

std::vector<Annotation> annotations_between(const ReportInput& input, double from, double to) {
  const Trajectory& trajectory = *input.run().shown->run.trajectory;
  std::vector<Annotation> found;
  for (const Annotation& annotation : input.annotations) {
    const double one = time_of(trajectory, annotation.place);
    const double other = has_two_places(annotation.kind) ? time_of(trajectory, annotation.until) : one;
    if (std::min(one, other) <= to && std::max(one, other) >= from) {
      found.push_back(annotation);
    }
  }
  return found;
}

namespace {

/// Numbers by the names of the pictures in figures.
std::map<QString, int> figure_numbers(const QString& html) {
  static const QRegularExpression shown(QStringLiteral("^\">\\s*<img src=\"picture:([^\"]*)\""));
  const QStringList parts = html.split(anchor_mark);
  std::map<QString, int> numbers;
  for (qsizetype i = 1; i < parts.size(); ++i) {
    if (const auto found = shown.match(parts[i]); found.hasMatch()) {
      numbers.try_emplace(found.captured(1), static_cast<int>(i));
    }
  }
  return numbers;
}

/// Replaces each mark by one text after the other.
QString with_marks_as(const QString& html, const QString& mark, const std::function<QString(int)>& text) {
  const QStringList parts = html.split(mark);
  QString made = parts.front();
  for (qsizetype i = 1; i < parts.size(); ++i) {
    made += text(static_cast<int>(i)) + parts[i];
  }
  return made;
}

/// A picture with an anchor, and its caption.
QString captioned(const QString& picture, const QString& caption) {
  return QStringLiteral("<a name=\"%1\">%2</a><p class=\"caption\">%3%4</p>")
      .arg(anchor_mark, picture, figure_mark, caption);
}

}  // namespace

QString with_figure_numbers(const QString& html) {
  const std::map<QString, int> numbers = figure_numbers(html);
  const auto anchor = [](int number) { return QStringLiteral("figure%1").arg(number); };
  QString made =
      with_marks_as(html, figure_mark, [](int number) { return ReportWords::tr("Figure %1. ").arg(number); });
  made = with_marks_as(made, anchor_mark, anchor);
  const QStringList parts = made.split(reference_mark);
  for (qsizetype i = 1; i < parts.size(); i += 2) {
    const auto found = numbers.find(parts[i]);
    made.replace(reference_mark + parts[i] + reference_mark,
                 found == numbers.end()
                     ? QString()
                     : QStringLiteral(" (<a href=\"#%1\">%2</a>)")
                           .arg(anchor(found->second), ReportWords::tr("Figure %1")
                                                           .arg(found->second)
                                                           .replace(' ', QStringLiteral("&nbsp;"))));
  }
  return made;
}

QString figure_reference(const QString& picture) {
  return picture.isEmpty() ? QString() : reference_mark + picture + reference_mark;
}

QString figure(const QString& picture, const QString& caption) {
  return QStringLiteral(
             "<table class=\"figure\" width=\"100%\" cellspacing=\"0\" cellpadding=\"0\"><tr><td>%1"
             "</td></tr></table>\n")
      .arg(captioned(picture, caption));
}

QString two_columns(const QString& left, const QString& right, int share) {
  constexpr int gap = 2;
  return QStringLiteral(
             "<table class=\"columns\" width=\"100%\" cellspacing=\"0\" cellpadding=\"0\"><tr>"
             "<td width=\"%3%\">%1</td><td width=\"%4%\"></td><td width=\"%5%\">%2</td></tr></table>\n")
      .arg(left, right)
      .arg(share)
      .arg(gap)
      .arg(100 - gap - share);
}

QString note_number(std::size_t note) {
  return QStringLiteral("%1 · ").arg(note + 1);
}

ReportInput without_other_runs(ReportInput input) {
  if (!needs_reference(input.scene.colouring)) {
    input.runs = {input.run()};
    input.current = 0;
  }
  return input;
}

QSizeF close_up_size() {
  constexpr double gap = 12;
  constexpr double height = 215;
  return {(report_width - (close_ups_a_row - 1) * gap) / close_ups_a_row, height};
}

QString close_up_table(const std::vector<std::pair<QString, QString>>& pictures) {
  QString rows;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t column = i % close_ups_a_row;
    const auto& [picture, caption] = pictures[i];
    rows += column == 0 ? QStringLiteral("<tr>") : QString();
    rows += QStringLiteral("<td width=\"50%\">%1</td>").arg(captioned(picture, caption));
    const bool last = column + 1 == close_ups_a_row || i + 1 == pictures.size();
    rows += last ? QStringLiteral("</tr>\n") : QString();
  }
  return rows.isEmpty() ? rows
                        : QStringLiteral(
                              "<table class=\"figure\" width=\"100%\" cellspacing=\"0\" "
                              "cellpadding=\"0\">\n%1</table>\n")
                              .arg(rows);
}

QString ReportPictures::add(const QString& name, ReportPicture picture, const QString& description) {
  const QSizeF size = picture.size;
  const bool wide = !picture.raster && size.width() >= report_width;  // a phone scrolls it
  pictures_.insert_or_assign(name, std::move(picture));
  descriptions_.insert_or_assign(name, description);
  return QStringLiteral("<img src=\"picture:%1\"%2 width=\"%3\" height=\"%4\" alt=\"%5\"/>")
      .arg(name, wide ? QStringLiteral(" class=\"wide\"") : QString())
      .arg(size.width())
      .arg(size.height())
      .arg(description.toHtmlEscaped());
}

QString ReportPictures::add_elastic(const QString& name, double width, ElasticPicture picture,
                                    const QString& description) {
  const QSizeF size(width, picture.largest);
  const QString html = add(name, picture.make(size), description);
  elastic_.insert_or_assign(name, std::move(picture));
  return html;
}

QString ReportPictures::description(const QString& name) const {
  const auto found = descriptions_.find(name);
  return found == descriptions_.end() ? QString() : found->second;
}

void ReportPictures::resize(const QString& name, double height) {
  ReportPicture& picture = pictures_.at(name);
  picture = elastic_.at(name).make({picture.size.width(), height});
}

void ReportPictures::paint(const QString& name, QPainter& painter, double pixel_ratio) const {
  const auto found = pictures_.find(name);
  if (found == pictures_.end()) {
    return;
  }
  if (progress_ != nullptr) {
    progress_->report(std::min(1.0, static_cast<double>(painted_++) / static_cast<double>(pictures_.size())));
  }
  found->second.paint(painter, pixel_ratio);
}

QString run_view(const ReportInput& input, ReportPictures& pictures, double height, const QString& caption) {
  const QString name = html_text(input.run().name);
  const QString usual = input.scene.exaggeration > 1
                            ? ReportWords::tr("Executed path of %1; deviations exaggerated %2 times.")
                                  .arg(name, significant_number(input.scene.exaggeration, 4))
                            : ReportWords::tr("Programmed and executed path of %1.").arg(name);
  return figure(pictures.add(QStringLiteral("view"), scene_picture(input, {report_width, height}),
                             ReportWords::tr("3D view")),
                caption.isEmpty() ? usual : caption);
}

QString elastic_view(const ReportInput& input, ReportPictures& pictures, const QString& caption) {
  constexpr double least = 190;
  constexpr double largest = 460;
  const auto make = [input](const QSizeF& size) {
    return ReportPicture{size, true, [input, size](QPainter& painter, double pixel_ratio) {
                           ScenePicture picture(input, input.current, ThemeKind::light);
                           paint_lightly(picture, painter, input, size, {pixel_ratio, 0.8});
                         }};
  };
  return figure(pictures.add_elastic(QStringLiteral("path"), report_width, {make, least, largest},
                                     ReportWords::tr("3D view")),
                caption);
}

QString view_block(const ReportInput& input, ReportPictures& pictures) {
  return run_view(input, pictures, view_height);
}

QString coloured_view(const ReportInput& input, Colouring colouring, const QString& name,
                      const QString& alternative, const QString& caption, ReportPictures& pictures) {
  ReportInput seen = input;
  seen.scene.colouring = colouring;
  return figure(pictures.add(name, scene_picture(seen, {report_width, view_height}), alternative), caption);
}

QString cause_view_block(const ReportInput& input, ReportPictures& pictures) {
  return coloured_view(
      input, Colouring::cause, QStringLiteral("causes"), ReportWords::tr("3D view by limiting cause"),
      ReportWords::tr("What limits the feed of %1 along the path.").arg(html_text(input.run().name)),
      pictures);
}

/// Names of the charts below that of the feed.
QString charts_of(const RunSources& sources) {
  QStringList names{ReportWords::tr("acceleration"), ReportWords::tr("jerk")};
  if (sources.actual) {
    names.append(ReportWords::tr("following error"));
  }
  if (sources.load) {
    names.append({ReportWords::tr("cutting force"), ReportWords::tr("chip thickness")});
  }
  if (sources.rotary) {
    names.append({ReportWords::tr("positions of rotary axes"), ReportWords::tr("their velocities")});
  }
  const QString last = names.takeLast();
  return ReportWords::tr("%1 and %2").arg(names.join(QStringLiteral(", ")), last);
}

/// Sentence after the caption of charts of a part of the run; empty for the whole run.
QString stretch_sentence(const ReportInput& input, const Trajectory& trajectory) {
  const auto& time = input.charts.time;
  const double rounding = 1e-6 * trajectory.duration();
  if (!time || (time->lower <= rounding && time->upper >= trajectory.duration() - rounding)) {
    return {};
  }
  return ' ' + ReportWords::tr("From %1 s to %2 s of %3 s.")
                   .arg(fixed(time->lower, 3), fixed(time->upper, 3), fixed(trajectory.duration(), 3));
}

QString run_charts(const ReportInput& input, std::size_t row, ReportPictures& pictures, double height,
                   const QString& caption) {
  const QSizeF size(report_width, height);
  constexpr double shrunk = 0.84;  // the charts are laid out larger
  const auto paint = [input, row, size](QPainter& painter, double pixel_ratio) {
    ChartsPage page;
    page.set_runs(input, row);
    page.hide_title();
    page.set_background(Qt::white);
    page.prepare((size / shrunk).toSize(), std::max(1.0, shrunk * pixel_ratio));
    painter.scale(shrunk, shrunk);
    page.draw(painter, false);
  };
  const QString name = input.runs[row].name;
  return figure(pictures.add(QStringLiteral("charts%1").arg(row), {size, false, paint},
                             ReportWords::tr("Charts of %1").arg(name)),
                (caption.isEmpty() ? ReportWords::tr("Feed with its limiting causes, %1 of %2.")
                                         .arg(charts_of(input.runs[row].shown->run.sources), html_text(name))
                                   : caption) +
                    stretch_sentence(input, *input.runs[row].shown->run.trajectory));
}

QString charts_block(const ReportInput& input, ReportPictures& pictures) {
  constexpr double height = 430;
  constexpr double another = 120;
  QString html;
  for (std::size_t i = 0; i < std::min(input.runs.size(), max_charts); ++i) {
    const RunSources& sources = input.runs[i].shown->run.sources;
    html += run_charts(input, i, pictures,
                       height + (sources.actual ? another : 0) + (sources.load ? 2 * another : 0) +
                           (sources.rotary ? 2 * another : 0));
  }
  return html;
}

QString bars_block(const ReportInput& input, ReportPictures& pictures) {
  std::vector<ComparedRun> runs;
  for (const ReportRun& run : input.runs) {
    runs.push_back(figures_of(run.shown->run));
  }
  auto chart = std::make_shared<ComparisonChart>();
  constexpr double shrunk = 0.72;
  const int width = static_cast<int>(report_width / shrunk);
  chart->set_comparison({}, {}, comparison_bars(runs));
  chart->ensurePolished();
  chart->resize(width, natural_comparison_height(chart->bars(), width, chart->font()));
  const QSizeF size(report_width, chart->height() * shrunk);
  return figure(pictures.add(QStringLiteral("bars"),
                             {size, false,
                              [chart](QPainter& painter, double) {
                                painter.scale(shrunk, shrunk);
                                chart->draw(painter);
                              }},
                             ReportWords::tr("Cycle times by limiting cause")),
                ReportWords::tr("Cycle times by limiting cause; the dashed line is the programmed time."));
}

QString slow_places_block(const ReportInput& input) {
  const Run& run = input.run().shown->run;
  const SlowPlaces& found = *input.run().shown->slow_places;
  HtmlTable table("rlrrl", {5, 19, 9, 16, 51});
  table.add_head({ReportWords::tr("No."), ReportWords::tr("Lines"), ReportWords::tr("Lost [s]"),
                  with_unit_of(ReportWords::tr("Feed"), Dimension::feed), ReportWords::tr("Why")});
  int number = 0;
  double listed = 0;
  for (const SimilarPlaces& places : worst_places(input, max_places)) {
    const SlowPlace& place = places.worst;
    const Explanation why = explain(run, run.trajectory->state(ruled_instant(*run.trajectory, place)));
    const QString cause = WhyText::cause(place.cause).toHtmlEscaped();
    table.add(
        {QString::number(++number), lines_text(places), fixed(places.loss, 3),
         ReportWords::tr("%1 of %2")
             .arg(fixed(place.feed, Dimension::feed), fixed(place.programmed_feed, Dimension::feed)),
         QStringLiteral("<b>%1.</b> %2").arg(cause, WhyText::sentence(place.cause, why).toHtmlEscaped())});
    listed += places.loss;
  }
  if (table.empty()) {
    return {};
  }
  return table.html() +
         caption_paragraph(
             ReportWords::tr(
                 "%1 places lose %2 s against the programmed feed; the %3 listed lose %4 s of it. "
                 "“Why” names what most of the time is lost to.")
                 .arg(found.count)
                 .arg(fixed(found.loss, 3))
                 .arg(number)
                 .arg(fixed(listed, 3)));
}

QString slow_place_views_block(const ReportInput& input, ReportPictures& pictures) {
  const std::vector<SimilarPlaces> places = worst_places(input, max_close_ups);
  std::vector<std::pair<QString, QString>> shown;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const QString number = QString::number(i + 1);
    shown.emplace_back(
        pictures.add(QStringLiteral("place%1").arg(number), close_up(input, places[i].worst, close_up_size()),
                     ReportWords::tr("Close-up of place %1").arg(number)),
        ReportWords::tr("Place %1: lines %2, %3 s lost.")
            .arg(number, lines_text(places[i]), fixed(places[i].loss, 3)));
  }
  return close_up_table(shown);
}

QString notes_block(const ReportInput& input) {
  const Trajectory& trajectory = *input.run().shown->run.trajectory;
  if (input.annotations.empty() || trajectory.pieces().empty()) {
    return {};
  }
  const std::vector<Segment>& segments = input.run().shown->run.path->segments;
  const QStringList texts = ScenePicture(input, input.current, ThemeKind::light).annotation_texts();
  HtmlTable table("rrrrl", {5, 14, 18, 21, 42});
  table.add_head({ReportWords::tr("No."), ReportWords::tr("Line"), ReportWords::tr("Time [s]"),
                  with_unit_of(ReportWords::tr("At X, Y, Z"), Dimension::length), ReportWords::tr("Note")});
  for (qsizetype i = 0; i < texts.size(); ++i) {
    const Annotation& annotation = input.annotations[static_cast<std::size_t>(i)];
    std::vector<ProgrammedPlace> marked{annotation.place};
    if (has_two_places(annotation.kind)) {
      marked.push_back(annotation.until);
      std::ranges::sort(marked, {}, [&](const ProgrammedPlace& place) { return time_of(trajectory, place); });
    }
    QStringList lines;
    QStringList instants;
    QStringList places;
    for (const ProgrammedPlace& place : marked) {
      const State state = trajectory.state(time_of(trajectory, place));
      const bool within = place.segment < segments.size();  // else the end of the program
      lines.append(QString::number(within ? segments[place.segment].line : state.line));
      instants.append(fixed(state.time, 3));
      places.append(ReportWords::tr("%1, %2, %3", "coordinates")
                        .arg(fixed(state.position.x(), Dimension::length),
                             fixed(state.position.y(), Dimension::length),
                             fixed(state.position.z(), Dimension::length)));
    }
    lines.removeDuplicates();
    const QString line_break = QStringLiteral("<br/>");
    const QString number = note_number(static_cast<std::size_t>(i));
    const QString text = texts[i].startsWith(number) ? texts[i].mid(number.size()) : texts[i];
    table.add({QString::number(i + 1), lines.join(QStringLiteral(" – ")), instants.join(line_break),
               places.join(line_break), html_text(text).replace('\n', line_break)});
  }
  return table.html();
}

}  // namespace feedscope::ui
