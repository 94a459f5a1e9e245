#include "ui/page/page_data.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>

#include "core/analysis/contour/path_deviation.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/study/recommendation.h"
#include "core/analysis/time/ruled_instant.h"
#include "core/export/export.h"
#include "ui/annotations/annotation_text.h"
#include "ui/language/in_language.h"
#include "ui/language/language.h"
#include "ui/page/page_columns.h"
#include "ui/page/page_texts.h"
#include "ui/page/rotary_curves.h"
#include "ui/page/run_nodes.h"
#include "ui/scene/cause_colour.h"
#include "ui/scene/colour_map.h"
#include "ui/units/unit_system.h"
#include "ui/why/why_text.h"
#include "ui/workbench/decision.h"

namespace feedscope::ui {
namespace {

constexpr double position_quantum = 2e-4;  // [mm]
constexpr double length_quantum = 1e-4;    // [mm]
constexpr double time_quantum = 1e-6;      // [s]
constexpr double speed_parts = 8192;       // of the largest speed
constexpr double peak_parts = 250;         // of the largest acceleration and jerk
constexpr double feed_quantum = 1e-3;      // [mm/s]
constexpr double limit_parts = 1000;       // of the limit of a rotary axis
constexpr std::size_t most_places = 60;    // of a run
constexpr std::size_t listed_places = 8;   // of a run, the worst; as web/places.js
constexpr double close_view_time = 0.2;    // [s]
constexpr std::size_t curve_share = 4;     // nodes of a run that may be for each point of a curve

using Position = std::array<std::int64_t, 3>;

Position position_steps(const Vec3& position) {
  return {steps(position.x(), position_quantum), steps(position.y(), position_quantum),
          steps(position.z(), position_quantum)};
}

/// The programmed path as in the page, to state the deviations of a run from it.
class ProgrammedSteps {
 public:
  explicit ProgrammedSteps(const std::vector<ProgrammedPoint>& points) {
    for (const ProgrammedPoint& point : points) {
      places_.push_back(steps(point.place, length_quantum));
      positions_.push_back(position_steps(point.position));
    }
  }

  /// Position at places in ascending order.
  Position at(std::int64_t place) {
    while (next_ + 1 < places_.size() && places_[next_] < place) {
      ++next_;
    }
    const std::size_t before = next_ > 0 ? next_ - 1 : 0;
    const auto length = static_cast<double>(places_[next_] - places_[before]);
    const double share = length > 0 ? static_cast<double>(place - places_[before]) / length : 0;
    Position at{};
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      const auto from = static_cast<double>(positions_[before][axis]);
      const auto to = static_cast<double>(positions_[next_][axis]);
      at[axis] = static_cast<std::int64_t>(std::floor(from + (to - from) * share + 0.5));
    }
    return at;
  }

 private:
  std::vector<std::int64_t> places_;
  std::vector<Position> positions_;
  std::size_t next_ = 0;
};

/// Differences between successive numbers.
class Deltas {
 public:
  void add(std::int64_t number) {
    column_.add(number - last_);
    last_ = number;
  }
  const PageColumn& column() const { return column_; }

 private:
  PageColumn column_;
  std::int64_t last_ = 0;
};

QJsonObject programmed_json(const std::vector<ProgrammedPoint>& points, PageData& data) {
  Deltas place, x, y, z, line, kind;
  for (const ProgrammedPoint& point : points) {
    const Position at = position_steps(point.position);
    place.add(steps(point.place, length_quantum));
    x.add(at[0]);
    y.add(at[1]);
    z.add(at[2]);
    line.add(point.line);
    kind.add(static_cast<std::int64_t>(point.kind));
  }
  QJsonObject columns;
  for (const auto& [name, values] : std::initializer_list<std::pair<const char*, const Deltas*>>{
           {"place", &place}, {"x", &x}, {"y", &y}, {"z", &z}, {"line", &line}, {"kind", &kind}}) {
    columns[QLatin1String(name)] = data.add(values->column());
  }
  return {{"count", static_cast<qint64>(points.size())}, {"columns", columns}};
}

/// Units of the columns of a run.
struct RunQuanta {
  double speed = 1;         ///< [mm/s]
  double acceleration = 1;  ///< [mm/s2]
  double jerk = 1;          ///< [mm/s3]
};

RunQuanta quanta_of(const std::vector<RunNode>& nodes) {
  RunQuanta top{0, 0, 0};
  for (const RunNode& node : nodes) {
    top.speed = std::max({top.speed, node.speed, node.middle_speed});
    top.acceleration = std::max({top.acceleration, node.acceleration, node.acceleration_after});
    top.jerk = std::max(top.jerk, node.jerk);
  }
  const auto part = [](double largest, double parts) { return largest > 0 ? largest / parts : 1; };
  return {part(top.speed, speed_parts), part(top.acceleration, peak_parts), part(top.jerk, peak_parts)};
}

/// Stores a middle speed as the difference from the mean of both ends, and a path length as the difference
/// from Simpson's rule.
QJsonObject nodes_json(const std::vector<RunNode>& nodes, ProgrammedSteps programmed, PageData& data) {
  const RunQuanta quanta = quanta_of(nodes);
  Deltas time, ahead, speed, acceleration, jerk, error, feed, line, cause, kind;
  PageColumn length, x, y, z, middle, after;
  const double simpson = quanta.speed * time_quantum / (6 * length_quantum);
  std::int64_t expected = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const RunNode& node = nodes[i];
    const RunNode& next = nodes[std::min(i + 1, nodes.size() - 1)];
    const std::int64_t at_time = steps(node.time, time_quantum);
    const std::int64_t travelled = steps(node.path_length, length_quantum);
    const std::int64_t place = steps(node.place, length_quantum);
    const std::int64_t start = steps(node.speed, quanta.speed);
    const std::int64_t end = steps(next.speed, quanta.speed);
    const std::int64_t halfway = steps(node.middle_speed, quanta.speed);
    time.add(at_time);
    length.add(travelled - expected);
    expected =
        travelled +
        steps(static_cast<double>((start + 4 * halfway + end) * (steps(next.time, time_quantum) - at_time)) *
                  simpson,
              1);
    ahead.add(place - travelled);
    const Position at = position_steps(node.position);
    const Position on = programmed.at(place);
    x.add(at[0] - on[0]);
    y.add(at[1] - on[1]);
    z.add(at[2] - on[2]);
    speed.add(start);
    middle.add(halfway - (start + end) / 2);
    acceleration.add(steps(node.acceleration, quanta.acceleration));
    after.add(steps(node.acceleration_after, quanta.acceleration) -
              steps(next.acceleration, quanta.acceleration));
    jerk.add(steps(node.jerk, quanta.jerk));
    error.add(steps(node.error, length_quantum));
    feed.add(steps(node.feed, feed_quantum));
    line.add(node.line);
    cause.add(static_cast<std::int64_t>(cause_index(node.cause)));
    kind.add(static_cast<std::int64_t>(node.kind));
  }
  QJsonObject columns;
  for (const auto& [name, values] :
       std::initializer_list<std::pair<const char*, const Deltas*>>{{"time", &time},
                                                                    {"ahead", &ahead},
                                                                    {"speed", &speed},
                                                                    {"acceleration", &acceleration},
                                                                    {"jerk", &jerk},
                                                                    {"error", &error},
                                                                    {"feed", &feed},
                                                                    {"line", &line},
                                                                    {"cause", &cause},
                                                                    {"kind", &kind}}) {
    columns[QLatin1String(name)] = data.add(values->column());
  }
  for (const auto& [name, values] : std::initializer_list<std::pair<const char*, const PageColumn*>>{
           {"length", &length}, {"x", &x}, {"y", &y}, {"z", &z}, {"middle", &middle}, {"after", &after}}) {
    columns[QLatin1String(name)] = data.add(*values);
  }
  return {{"count", static_cast<qint64>(nodes.size())},
          {"columns", columns},
          {"speed_step", quanta.speed},
          {"acceleration_step", quanta.acceleration},
          {"jerk_step", quanta.jerk}};
}

QJsonArray rotary_json(const std::vector<RotaryCurve>& curves, PageData& data) {
  QJsonArray list;
  for (const RotaryCurve& curve : curves) {
    const double quantum = curve.limit / limit_parts;
    Deltas time, value;
    for (const CurvePoint& point : curve.points) {
      time.add(steps(point.time, time_quantum));
      value.add(steps(point.value, quantum));
    }
    list.append(QJsonObject{
        {"kind", QString::fromUtf8(info_of(curve.kind).key.data(),
                                   static_cast<qsizetype>(info_of(curve.kind).key.size()))},
        {"axis", QString(QLatin1Char(curve.axis))},
        {"limit", curve.limit},
        {"precision", curve.precision + 1 / limit_parts},
        {"step", quantum},
        {"count", static_cast<qint64>(curve.points.size())},
        {"columns", QJsonObject{{"time", data.add(time.column())}, {"value", data.add(value.column())}}}});
  }
  return list;
}

QString hex(const Rgb& colour) {
  return QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                          static_cast<float>(colour[2]))
      .name();
}

QJsonArray scale_json(const std::function<Rgb(double)>& colour, double low) {
  constexpr int parts = 64;
  QJsonArray colours;
  for (int i = 0; i <= parts; ++i) {
    colours.append(hex(colour(low + (1 - low) * i / parts)));
  }
  return colours;
}

QJsonObject colours_json(Background background) {
  QJsonArray causes;
  for (const Cause& cause : all_causes()) {
    causes.append(hex(cause_colour(cause.kind, background)));
  }
  return {{"feed", scale_json([&](double value) { return map_colour(value, background); }, 0)},
          {"lost", scale_json([&](double value) { return diverging_colour(value, background); }, -1)},
          {"causes", causes}};
}

QJsonArray cause_titles() {
  QJsonArray titles;
  for (const Cause& cause : all_causes()) {
    titles.append(WhyText::cause(cause));
  }
  return titles;
}

/// In the order used by figures.
QJsonArray cause_keys() {
  QJsonArray keys;
  for (const Cause& cause : all_causes()) {
    keys.append(QString::fromStdString(cause_key(cause)));
  }
  return keys;
}

/// The places with the largest loss, in order of time, each with a sentence on its cause.
/// The places of a run that lose most, the first of all first.
std::vector<SlowPlace> worst_places(const ShownRun& shown) {
  const SlowPlaces found = shown.slow_places ? *shown.slow_places : find_slow_places(*shown.run.trajectory);
  std::vector<SlowPlace> places = found.places;
  std::ranges::stable_sort(places, std::ranges::greater(), &SlowPlace::loss);
  places.resize(std::min(places.size(), most_places));
  return places;
}

QJsonArray places_json(const ShownRun& shown, std::vector<SlowPlace> places) {
  const Trajectory& trajectory = *shown.run.trajectory;
  std::ranges::sort(places, {}, &SlowPlace::from);
  QJsonArray list;
  for (const SlowPlace& place : places) {
    const double at = ruled_instant(trajectory, place);
    const Explanation why = explain(shown.run, trajectory.state(at));
    list.append(QJsonObject{{"from", place.from},
                            {"to", place.to},
                            {"at", at},
                            {"loss", place.loss},
                            {"line", static_cast<qint64>(place.line)},
                            {"cause", static_cast<qint64>(cause_index(place.cause))},
                            {"why", WhyText::sentence(place.cause, why)}});
  }
  return list;
}

/// The surroundings of the listed places of a run, on its programmed path.
void add_close_views(const ShownRun& shown, const std::vector<SlowPlace>& places,
                     std::vector<CloseView>& views) {
  const Trajectory& trajectory = *shown.run.trajectory;
  PathDeviation deviation(*trajectory.path().programmed());
  std::vector<double> starts{0};
  for (const Segment& segment : trajectory.path().programmed()->segments) {
    starts.push_back(starts.back() + segment.length);
  }
  const auto place_at = [&](double time) {
    const State state = trajectory.state(time);
    const PathDeviation::Foot foot =
        deviation.foot_near(trajectory.path().segment(state.element), state.position);
    return starts[foot.segment] + foot.s;
  };
  for (const SlowPlace& place : places | std::views::take(listed_places)) {
    const double at = ruled_instant(trajectory, place);
    views.push_back({place_at(at - close_view_time / 2), place_at(at + close_view_time / 2)});
  }
}

/// In order, those that overlap as one.
std::vector<CloseView> joined(std::vector<CloseView> views) {
  std::ranges::sort(views, {}, &CloseView::from);
  std::vector<CloseView> apart;
  for (const CloseView& view : views) {
    if (!apart.empty() && view.from <= apart.back().to) {
      apart.back().to = std::max(apart.back().to, view.to);
    } else {
      apart.push_back(view);
    }
  }
  return apart;
}

/// The output of `simulate --json`, without parts that vary or are not shown.
QJsonObject figures_json(const ReportRun& run, const ComparedRun& figures) {
  const std::string text = simulation_json(run.shown->run, figures);
  QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  for (const char* name : {"elapsed", "diagnostics", "settings"}) {
    json.remove(QLatin1String(name));
  }
  return json;
}

/// The annotations of a session at the times of the current run.
QJsonArray annotations_json(const ReportInput& input) {
  const Trajectory& trajectory = *input.run().shown->run.trajectory;
  QJsonArray list;
  if (trajectory.pieces().empty()) {
    return list;
  }
  PathDeviation deviation(*trajectory.path().programmed());
  for (const Annotation& annotation : input.annotations) {
    AnnotationValues values{.at = trajectory.state(time_of(trajectory, annotation.place)),
                            .run = input.run().name};
    values.contour_error =
        deviation(values.at.position, trajectory.path().segment(values.at.element)).nearest.norm();
    QJsonObject json{{"time", values.at.time},
                     {"kind", annotation_key(annotation.kind)},
                     {"colour", annotation.colour.name()},
                     {"right", annotation.offset.x()},
                     {"down", annotation.offset.y()}};
    if (has_two_places(annotation.kind)) {
      const State end = trajectory.state(time_of(trajectory, annotation.until));
      values.distance = (end.position - values.at.position).norm();
      values.duration = end.time - values.at.time;
      json["until"] = end.time;
    }
    json["text"] = with_values(annotation.text, values);
    list.append(json);
  }
  return list;
}

class PageWriter {
 public:
  PageWriter(const ReportInput& input, std::size_t most_nodes)
      : input_(input), most_(most_nodes / input.runs.size()) {
    for (const ReportRun& run : input.runs) {
      for (const CauseKind kind : deciding_rotary_limits(run.shown->run)) {
        if (std::ranges::find(rotary_limits_, kind) == rotary_limits_.end()) {
          rotary_limits_.push_back(kind);
        }
      }
    }
  }

  QByteArray write(Progress* progress) {
    const std::vector<ComparedRun> figures = run_figures(input_);
    const std::vector<bool> can = can_be_chosen(figures);
    find_places();
    QJsonArray runs;
    for (std::size_t i = 0; i < input_.runs.size(); ++i) {
      QJsonObject run = run_json(i, progress);
      run["figures"] = figures_json(input_.runs[i], figures[i]);
      run["choice"] = QJsonObject{{"time", figures[i].summary.cycle_time},
                                  {"error", deciding_error(figures[i].summary)},
                                  {"actual", figures[i].summary.actual.has_value()},
                                  {"lines_not_run", static_cast<qint64>(figures[i].lines_not_run)},
                                  {"competes", bool(can[i])},
                                  {"other_model", figures[i].is_possible() && !can[i]}};
      QJsonArray texts;
      for (const Remark& remark : remarks(input_.runs[i].shown->run, unit_system())) {
        texts.append(in_language(remark.text));
      }
      run["remarks"] = texts;
      runs.append(run);
    }
    const QLocale locale;
    const QJsonObject description{
        {"language", spoken_language()},
        {"decimal", QString(locale.decimalPoint())},
        {"version", QStringLiteral(FEEDSCOPE_VERSION)},
        {"texts", page_texts()},
        {"units", page_units()},
        {"colours",
         QJsonObject{{"light", colours_json(Background::light)}, {"dark", colours_json(Background::dark)}}},
        {"causes", cause_titles()},
        {"cause_keys", cause_keys()},
        {"steps", QJsonObject{{"position", position_quantum},
                              {"length", length_quantum},
                              {"time", time_quantum},
                              {"feed", feed_quantum}}},
        {"program", QJsonObject{{"name", program_file_name(*input_.program().program)}, {"text", text()}}},
        {"title", input_.heading()},
        {"common", common_name(input_)},
        {"programmed", programmed_},
        {"runs", runs},
        {"annotations", annotations_json(input_)},
        {"current", static_cast<qint64>(input_.current)},
        {"without_choice",
         leading_run(figures, std::nullopt) ? QString() : DecisionTexts::decision(figures, {}, {}).headline},
        {"within", input_.within ? QJsonValue(*input_.within) : QJsonValue()}};
    return data_.packed(description);
  }

 private:
  void find_places() {
    for (const ReportRun& run : input_.runs) {
      const bool moves = !run.shown->run.trajectory->pieces().empty();
      places_.push_back(moves ? worst_places(*run.shown) : std::vector<SlowPlace>{});
      if (moves) {
        add_close_views(*run.shown, places_.back(), views_);
      }
    }
    views_ = joined(std::move(views_));
  }

  QString text() const {
    const SourceText& source = *input_.program().program->source;
    QString text;
    for (std::uint32_t line = 1; line <= source.line_count(); ++line) {
      text += QString::fromStdString(source.utf8_line(line)) + QLatin1Char('\n');
    }
    return text;
  }

  /// Index of the programmed path, which runs may share.
  std::size_t programmed_of(const Trajectory& trajectory) {
    const auto known = std::ranges::find(paths_, trajectory.path().programmed());
    if (known != paths_.end()) {
      return static_cast<std::size_t>(known - paths_.begin());
    }
    paths_.push_back(trajectory.path().programmed());
    const std::vector<ProgrammedPoint> points = programmed_points(*paths_.back(), position_quantum);
    programmed_.append(programmed_json(points, data_));
    steps_.emplace_back(points);
    return paths_.size() - 1;
  }

  QJsonObject run_json(std::size_t i, Progress* progress) {
    const ReportRun& run = input_.runs[i];
    const Trajectory& trajectory = *run.shown->run.trajectory;
    QJsonArray dashes;
    for (const qreal dash : run_dashes(i)) {
      dashes.append(dash);
    }
    QJsonObject json{{"letter", run_letter(i)},
                     {"name", short_names(input_)[static_cast<qsizetype>(i)]},
                     {"full_name", run.name},
                     {"colour", run.colour.name()},
                     {"dashes", dashes}};
    const auto tolerance = contour_tolerance(run.shown->run.setup);
    json["tolerance"] = tolerance ? QJsonValue(*tolerance) : QJsonValue();
    if (trajectory.pieces().empty()) {
      return json;
    }
    const std::size_t programmed = programmed_of(trajectory);
    const double top_feed = run.shown->samples->peak_feed;
    const RunNodes nodes = run_nodes(trajectory, top_feed, most_, views_, progress);
    json["programmed"] = static_cast<qint64>(programmed);
    json["nodes"] = nodes_json(nodes.nodes, steps_[programmed], data_);
    json["top_feed"] = top_feed;
    json["precision"] =
        QJsonObject{{"position", 2 * nodes.precision.position}, {"speed", 2 * nodes.precision.speed}};
    json["rotary"] =
        rotary_json(rotary_curves(run.shown->run, rotary_limits_, most_ / curve_share, progress), data_);
    json["places"] = places_json(*run.shown, places_[i]);
    return json;
  }

  const ReportInput& input_;
  std::size_t most_;
  std::vector<CauseKind> rotary_limits_;        ///< that slow one of the runs
  std::vector<std::vector<SlowPlace>> places_;  ///< of each run
  std::vector<CloseView> views_;                ///< of the listed places of all runs
  PageData data_;
  QJsonArray programmed_;
  std::vector<std::shared_ptr<const Toolpath>> paths_;
  std::vector<ProgrammedSteps> steps_;
};

}  // namespace

QByteArray page_data(const ReportInput& input, Progress* progress, std::size_t most_nodes) {
  return PageWriter(input, most_nodes).write(progress);
}

}  // namespace feedscope::ui
