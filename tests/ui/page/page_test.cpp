#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/analysis/run/run.h"
#include "core/base/data_folder.h"
#include "ui/page/page.h"
#include "ui/page/page_columns.h"
#include "ui/page/rotary_curves.h"
#include "ui/page/run_nodes.h"

namespace feedscope::ui {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Run page_run(const std::string& text, const char* model, double tolerance) {
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("page.nc", text));
  return simulate_run(program, make_setup({"spinner-mvc850", model, tolerance}));
}

/// Lines and half circles from the origin on.
std::string random_page_program(std::mt19937& random) {
  std::uniform_real_distribution<double> step(-20, 20);
  std::uniform_real_distribution<double> feed(200, 6000);
  std::string text = "G90 G17\n";
  double x = 0;
  double y = 0;
  for (int i = 0; i < 25; ++i) {
    const double next_x = x + step(random);
    const double next_y = y + step(random);
    text += i % 5 == 4 ? fmt::format("G2 X{:.3f} Y{:.3f} I{:.5f} J{:.5f}\n", next_x, next_y, (next_x - x) / 2,
                                     (next_y - y) / 2)
                       : fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} F{:.0f}\n", next_x, next_y,
                                     step(random) / 20, feed(random));
    x = next_x;
    y = next_y;
  }
  return text;
}

double top_feed_of(const struct Run& run) {
  return run.summary.peak_feed;
}

/// How far a run drawn from two nodes is from the run between them, at most.
NodePrecision deviation_between(const Trajectory& trajectory, const RunNode& from, const RunNode& to) {
  NodePrecision most;
  for (const double share : {0.1, 0.25, 0.4, 0.5, 0.7, 0.9}) {
    const State state = trajectory.state(from.time + share * (to.time - from.time));
    const double speed = from.speed + share * (4 * from.middle_speed - 3 * from.speed - to.speed) +
                         share * share * 2 * (from.speed + to.speed - 2 * from.middle_speed);
    const double length = to.path_length - from.path_length;
    const double along = length > 0 ? (state.path_length - from.path_length) / length : 0;
    const Vec3 drawn = from.position + along * (to.position - from.position);
    most.position = std::max(most.position, (drawn - state.position).norm());
    most.speed = std::max(most.speed, std::abs(speed - state.speed));
  }
  return most;
}

TEST(PageColumn, WritesSmallNumbersInOneByte) {
  PageColumn column;
  for (const std::int64_t number : {0, -1, 1, 63, 64, -65}) {
    column.add(number);
  }
  EXPECT_EQ(column.bytes().toHex(), "0001027e80018101");
}

/// On a line a part of constant jerk is a cubic in time: one node is enough, whatever its length.
TEST(RunNodes, TakeOneNodeForEachPartOfALine) {
  const feedscope::Run run = page_run("G1 X100 F3000\n", "essid", 0.01);
  const RunNodes nodes = run_nodes(*run.trajectory, top_feed_of(run), 1000);
  EXPECT_LE(nodes.nodes.size(), 9);
  EXPECT_DOUBLE_EQ(nodes.nodes.back().time, run.trajectory->duration());
  EXPECT_NEAR(nodes.nodes.back().path_length, 100, 1e-9);
}

TEST(RunNodes, StayWithinTheirPrecisionOnRandomPrograms) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    const std::string text = random_page_program(random);
    for (const char* model : {"essid", "msaddek", "ward"}) {
      const feedscope::Run run = page_run(text, model, 0.05);
      const RunNodes nodes = run_nodes(*run.trajectory, top_feed_of(run), 1'000'000);
      double place = 0;
      for (std::size_t i = 0; i + 1 < nodes.nodes.size(); ++i) {
        const NodePrecision away = deviation_between(*run.trajectory, nodes.nodes[i], nodes.nodes[i + 1]);
        // Between the three instants that are looked at a little more is possible.
        ASSERT_LE(away.position, 1.5 * nodes.precision.position) << model << " node " << i << '\n' << text;
        ASSERT_LE(away.speed, 1.5 * nodes.precision.speed) << model << " node " << i << '\n' << text;
        ASSERT_GE(nodes.nodes[i].place, place);
        place = nodes.nodes[i].place;
      }
    }
  }
}

TEST(RunNodes, AreAsManyAsAskedForAndSayHowCoarseTheyAre) {
  std::mt19937 random(7);
  const feedscope::Run run = page_run(random_page_program(random), "essid", 0.05);
  const double top_feed = top_feed_of(run);
  const RunNodes all = run_nodes(*run.trajectory, top_feed, 1'000'000);
  const RunNodes few = run_nodes(*run.trajectory, top_feed, all.nodes.size() / 8);
  EXPECT_LE(few.nodes.size(), all.nodes.size() / 8);
  EXPECT_GT(few.precision.speed, all.precision.speed);
  EXPECT_DOUBLE_EQ(few.nodes.back().time, all.nodes.back().time);
  for (std::size_t i = 0; i + 1 < few.nodes.size(); ++i) {
    const NodePrecision away = deviation_between(*run.trajectory, few.nodes[i], few.nodes[i + 1]);
    EXPECT_LE(away.position, 1.5 * few.precision.position) << "node " << i;
    EXPECT_LE(away.speed, 1.5 * few.precision.speed) << "node " << i;
  }
}

TEST(RunNodes, LeaveNothingOutWhereOneLooksFromClose) {
  std::mt19937 random(7);
  const feedscope::Run run = page_run(random_page_program(random), "essid", 0.05);
  const double top_feed = top_feed_of(run);
  const RunNodes all = run_nodes(*run.trajectory, top_feed, 1'000'000);
  const double middle = all.nodes[all.nodes.size() / 2].place;
  const std::vector<CloseView> views{{middle - 1, middle + 1}};
  const RunNodes few = run_nodes(*run.trajectory, top_feed, all.nodes.size() / 8, views);
  EXPECT_LE(few.nodes.size(), all.nodes.size() / 8);
  const auto seen = [&](const RunNodes& nodes) {
    return std::ranges::count_if(nodes.nodes, [&](const RunNode& node) {
      return node.place >= views[0].from && node.place <= views[0].to;
    });
  };
  EXPECT_GT(seen(all), seen(run_nodes(*run.trajectory, top_feed, all.nodes.size() / 8)));
  EXPECT_EQ(seen(few), seen(all));
}

/// What is drawn at a time, straight between the points.
double drawn_at(const RotaryCurve& curve, double time) {
  const auto next = std::ranges::lower_bound(curve.points, time, {}, &CurvePoint::time);
  if (next == curve.points.begin() || next == curve.points.end()) {
    return next == curve.points.end() ? curve.points.back().value : next->value;
  }
  const CurvePoint& before = *(next - 1);
  return before.value + (next->value - before.value) * (time - before.time) / (next->time - before.time);
}

double AxisState::*value_of(const RotaryCurve& curve) {
  return curve.kind == CauseKind::axis_velocity       ? &AxisState::velocity
         : curve.kind == CauseKind::axis_acceleration ? &AxisState::acceleration
                                                      : &AxisState::jerk;
}

struct Run singular_run() {
  const Setup setup = make_setup({"five-axis-table-ac", "essid", 0.02});
  return simulate_run(load_program(data_folder() / "resources/programs/lesson_singular.nc", nullptr,
                                   reading_on({}, setup.machine)),
                      setup);
}

/// Share of random times at which a curve is farther from the run than it says.
double share_beyond_precision(const RotaryCurve& curve, const feedscope::Run& run) {
  constexpr int looks = 5000;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> times(0, run.trajectory->duration());
  int beyond = 0;
  for (int i = 0; i < looks; ++i) {
    const double time = times(random);
    const RotarySample sample = run.sources.rotary->at(run.trajectory->state(time));
    const double value = sample.rotary[rotary_names.find(curve.axis)].*value_of(curve);
    beyond += std::abs(drawn_at(curve, time) - value) > curve.precision * curve.limit;
  }
  return static_cast<double>(beyond) / looks;
}

TEST(RotaryCurves, AreOfTheLimitsThatSlowTheRun) {
  const feedscope::Run run = singular_run();
  const std::vector<CauseKind> kinds = deciding_rotary_limits(run);
  EXPECT_THAT(kinds, ::testing::Contains(CauseKind::axis_jerk)) << "that of C, as lesson 11 says";
  EXPECT_THAT(deciding_rotary_limits(page_run("G1 X100 F3000\n", "essid", 0.01)), ::testing::IsEmpty());
  EXPECT_THAT(rotary_curves(page_run("G1 X100 F3000\n", "essid", 0.01), kinds, 1000), ::testing::IsEmpty());
}

TEST(RotaryCurves, StayWithinTheirPrecisionButWhereTheyJump) {
  const feedscope::Run run = singular_run();
  const auto curves = rotary_curves(
      run, {CauseKind::axis_velocity, CauseKind::axis_acceleration, CauseKind::axis_jerk}, 1'000'000);
  ASSERT_EQ(curves.size(), 6);
  for (const RotaryCurve& curve : curves) {
    EXPECT_DOUBLE_EQ(curve.precision, 0.01);
    EXPECT_LE(share_beyond_precision(curve, run), 0.002) << curve.axis << ' ' << info_of(curve.kind).key;
  }
  const auto few = rotary_curves(run, {CauseKind::axis_velocity}, curves.front().points.size() / 4);
  ASSERT_EQ(few.size(), 2);
  EXPECT_LE(few.front().points.size(), curves.front().points.size() / 4);
  EXPECT_GT(few.front().precision, 0.01);
  EXPECT_LE(share_beyond_precision(few.front(), run), 0.002);
}

/// The sagitta of a chord c of an arc with radius r is c^2 / (8 r).
TEST(ProgrammedPoints, AreChordsOfArcs) {
  const feedscope::Run run = page_run("G17 G2 X20 Y0 I10 J0 F1000\n", "essid", 0.01);
  constexpr double precision = 1e-3;
  const auto points = programmed_points(*run.trajectory->path().programmed(), precision);
  const Vec3 centre(10, 0, 0);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 middle = (points[i].position + points[i + 1].position) / 2;
    EXPECT_LE(10 - (middle - centre).norm(), 1.01 * precision);
  }
  EXPECT_EQ(points.back().kind, NodeKind::cut);
  EXPECT_EQ(points[1].kind, NodeKind::arc);
}

TEST(Page, ContainsNothingThatCouldEndItsScriptsOrAskANetwork) {
  const QString html =
      with_view(QStringLiteral("<html><head><title>a</title></head><body><p>b</p></body></html>"),
                QByteArray("</script><script>alert(1)</script>"));
  const std::string text = html.toStdString();
  EXPECT_THAT(text, HasSubstr("<head><meta http-equiv=\"Content-Security-Policy\""));
  EXPECT_THAT(text, HasSubstr("default-src 'none'"));
  EXPECT_THAT(text, Not(HasSubstr("alert(1)")));
  EXPECT_THAT(text, Not(HasSubstr(" src=\"http")));
  EXPECT_THAT(text, HasSubstr("<p>b</p>"));
  EXPECT_TRUE(text.ends_with("</body></html>"));
}

}  // namespace
}  // namespace feedscope::ui
