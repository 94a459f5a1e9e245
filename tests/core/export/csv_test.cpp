#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/drives/drive_response.h"
#include "core/export/export.h"
#include "core/load/load_model.h"
#include "core/models/control_model.h"
#include "core/trajectory/trajectory_builder.h"
#include "tests/support/paths.h"

namespace feedscope {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* csv_header =
    "time_s,path_mm,line,x_mm,y_mm,z_mm,feed_mm_min,programmed_feed_mm_min,vx_mm_min,vy_mm_min,vz_mm_min,"
    "ax_m_s2,ay_m_s2,az_m_s2,jx_m_s3,jy_m_s3,jz_m_s3,at_m_s2,jt_m_s3,cause,an_m_s2\n";

/// 0.02 s up by jerk 1000 mm/s3 times -1 in X and steady after it for 0.03 s, from line 7.
Trajectory ramp_and_cruise() {
  auto toolpath = std::make_shared<Toolpath>();
  toolpath->start = Vec3(1, 2, 3);
  Segment line;
  line.end = Vec3(-9, 2, 3);
  line.length = 10;
  line.feed = 10;
  line.line = 7;
  toolpath->segments = {line};
  TrajectoryBuilder builder(toolpath, Vec3::Constant(500));
  builder.add_segment(0);
  builder.add_piece({0, 0, 5, 0, 1000, 0, {CauseKind::axis_jerk, 0}}, 0.02);
  builder.add_piece({0, 1, 10, 0, 0, 0, {CauseKind::programmed_feed}}, 0.03);
  return builder.finish();
}

std::string csv(const Trajectory& trajectory, double step) {
  std::ostringstream out;
  write_csv(out, trajectory, step);
  return out.str();
}

std::size_t rows(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) - 1;
}

TEST(Csv, HoldsARowEachStepAndOneForTheEnd) {
  std::string expected = csv_header;
  expected +=
      "0,0,7,1,2,3,300,600,-300,0,0,0,0,0,-1,0,0,0,1,axis_jerk_x,0\n"
      "0.02,1,7,0,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed,0\n"
      "0.04,1.2,7,-0.2,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed,0\n"
      "0.05,1.3,7,-0.3,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed,0\n";
  EXPECT_EQ(csv(ramp_and_cruise(), 0.02), expected);
}

TEST(Csv, DoesNotRepeatTheEndThatFallsOnAStep) {
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.05)), 2U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.01)), 6U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.05 / 3)), 4U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 1)), 2U);
}

TEST(Csv, NeverPrintsTheSameTimeTwice) {
  for (int i = 1; i < 400; ++i) {
    for (const double off : {-1e-9, -3e-11, -1e-11, -1e-13, 0.0, 1e-13, 1e-11, 3e-11, 1e-9}) {
      std::istringstream lines;
      lines.str(csv(ramp_and_cruise(), 0.05 / i * (1 + off)));
      std::string before;
      for (std::string row; std::getline(lines, row);) {
        row.resize(row.find(','));
        EXPECT_NE(row, before) << "step 0.05 s / " << i << ", off by " << off;
        before = row;
      }
      EXPECT_EQ(before, "0.05");
    }
  }
}

TEST(Csv, OfNothingIsTheHeader) {
  EXPECT_EQ(csv({}, 0.001), csv_header);
}

TEST(Csv, RefusesStepsThatNobodyMeans) {
  for (const double step : {0.0, -1.0, 1e-12, std::nan("")}) {
    EXPECT_THAT([&] { csv(ramp_and_cruise(), step); },
                ThrowsMessage<InputError>(HasSubstr("use a larger step")));
  }
}

TEST(Csv, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  std::ostringstream out;
  EXPECT_THROW(write_csv(out, ramp_and_cruise(), 0.001, &progress), Cancelled);
}

class DecimalComma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Csv, DoesNotDependOnTheLocale) {
  const std::string plain = csv(ramp_and_cruise(), 0.01);
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string with_comma = csv(ramp_and_cruise(), 0.01);
  std::locale::global(before);
  EXPECT_EQ(with_comma, plain);
}

TEST(BlendsCsv, HoldsARowEachBlendInUnitsOfItsColumns) {
  // Right angles of lines 1 and 2 from T before to T behind; a circle arc has T = R, eps = R (sqrt(2) - 1).
  const auto toolpath = std::make_shared<const Toolpath>(
      feedscope::testing::polyline({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {8, 4, 0}}, 10));
  TrajectoryBuilder builder(toolpath, Vec3::Constant(500));
  builder.add_segment(0, 3);
  builder.add_corner(ElementKind::connecting_arc, 0, 1, std::acos(-1.0) / 2);
  builder.add_segment(1, 2);
  builder.add_corner(ElementKind::blend, 1, 1, 1.5);
  builder.add_segment(2, 3);
  for (std::uint32_t e = 0; e < 5; ++e) {
    const bool cubic = e == 3;  // u from 0 to 1 in half a second
    builder.add_piece({0, 0, cubic ? 2.0 : 10.0, 0, 0, e, {}, cubic ? Law::parameter : Law::path_length},
                      cubic ? 0.5 : builder.path().length(e) / 10);
  }
  std::ostringstream out;
  write_blends(out, builder.finish());
  // alpha = 2.5: eps = 1.5 sin(45) / 4, speed at the ends 2 * 2.5 mm/s, least radius in the middle
  // 8 eps (3/2 - alpha/4)^2 / (alpha (4 - alpha))
  EXPECT_EQ(out.str(),
            "line,kind,x_mm,y_mm,z_mm,turn_deg,transition_mm,epsilon_mm,length_mm,min_radius_mm,"
            "entry_feed_mm_min,exit_feed_mm_min\n"
            "1,arc,4,0,0,90,1,0.41421356237,1.5707963268,1,600,600\n"
            "2,cubic,4,4,0,90,1,0.26516504294,1.5,0.43310290348,300,300\n");
}

/// Constant velocity: each axis is (1 - f) v/Kv behind, once it has settled.
TEST(Csv, DrivesAddTheirColumnsBehindTheOthers) {
  const ControlModel& cam = find_model("cam");
  Machine machine = feedscope::testing::spinner();
  set_axis_value(machine, 'X', "kv", 50.0);
  set_axis_value(machine, 'Y', "kv", 40.0);
  set_axis_value(machine, 'Y', "velocity_feedforward", 0.5);
  const auto run = std::make_shared<const Trajectory>(cam.simulate(
      feedscope::testing::polyline({{0, 0, 0}, {60, 80, 0}}, 50), machine, complete_settings(cam, machine)));
  RunSources sources;
  sources.actual = std::make_shared<const ActualPath>(run, machine);
  std::ostringstream out;
  write_csv(out, *run, 1.0, nullptr, sources);
  std::istringstream lines(out.str());
  std::string header;
  std::getline(lines, header);
  const std::string plain(csv_header);
  EXPECT_EQ(header, plain.substr(0, plain.size() - 1) +
                        ",actual_x_mm,actual_y_mm,actual_z_mm,following_error_x_um,following_error_y_um,"
                        "following_error_z_um,actual_contour_error_um");
  std::string row;
  std::getline(lines, row);  // at rest
  std::getline(lines, row);  // after 1 s, at (30, 40), with 30 and 40 mm/s: 600 and 500 um behind
  std::vector<double> values;
  std::istringstream fields(row.substr(row.find("programmed_feed,") + 16));
  for (std::string field; std::getline(fields, field, ',');) {
    values.push_back(std::stod(field));
  }
  ASSERT_EQ(values.size(), 8U);
  EXPECT_NEAR(values[1], 30 - 0.6, 1e-9);
  EXPECT_NEAR(values[2], 40 - 0.5, 1e-9);
  EXPECT_NEAR(values[3], 0, 1e-12);
  EXPECT_NEAR(values[4], 600, 1e-6);
  EXPECT_NEAR(values[5], 500, 1e-6);
  EXPECT_NEAR(values[6], 0, 1e-9);
  // Across the direction (0.6, 0.8): |0.6 * 0.8 - 0.5 * 0.6| mm.
  EXPECT_NEAR(values[7], 180, 1e-6);
}

/// Columns of the axes that the machine has, behind all others: 30 and 90 degrees, at rest in the end.
TEST(Csv, HasTheRotaryAxesOfTheMachineLast) {
  SetupRequest request;
  request.machine = "five-axis-table-ac";
  const feedscope::Setup setup = make_setup(request);
  const auto program =
      load_program(std::make_shared<const SourceText>("test.nc", "G21\nG0 X5\nG0 A30 C-90\n"), nullptr,
                   reading_on({}, setup.machine));
  const feedscope::Run run = simulate_run(program, setup);
  std::ostringstream out;
  write_csv(out, *run.trajectory, 1.0, nullptr, run.sources);
  const std::string text = out.str();
  const std::string plain(csv_header);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            plain.substr(0, plain.size() - 1) +
                ",a_deg,c_deg,va_rev_min,vc_rev_min,aa_rev_s2,ac_rev_s2,ja_rev_s3,jc_rev_s3");
  EXPECT_THAT(text, ::testing::EndsWith(",30,-90,0,0,0,0,0,0\n"));
}

/// Steady at 10 mm/s over 100/s and two teeth; nothing where no operation applies.
TEST(Csv, HasTheLoadBehindAllOthersAndEmptyWhereThereIsNone) {
  const auto run = std::make_shared<const Trajectory>(ramp_and_cruise());
  Program program;
  program.source = std::make_shared<const SourceText>("part.nc", "\n\n\n\n\n\nG1\nG1\n");
  Engagement operation;
  operation.diameter = operation.radial_depth = 10;
  operation.teeth = 2;
  operation.axial_depth = 1;
  operation.material = "steel-c45";
  operation.spindle_speed = 100;
  const auto text = [&](std::uint32_t line) {
    operation.lines = {{line, line}};
    RunSources sources;
    sources.load = std::make_shared<const RunLoad>(
        run, LoadModel({{operation}, {}}, program, *run->path().programmed()));
    std::ostringstream out;
    write_csv(out, *run, 0.02, nullptr, sources);
    return out.str();
  };
  const std::string with = text(7);
  const std::string plain(csv_header);
  EXPECT_EQ(
      with.substr(0, with.find('\n')),
      plain.substr(0, plain.size() - 1) +
          ",feed_per_tooth_mm,torque_nm,power_kw,cutting_force_mean_n,cutting_force_peak_n,chip_thickness_um,"
          "chip_thickness_programmed_um,cutting_force_peak_programmed_n,cutting_force_mean_programmed_n,"
          "feed_per_tooth_programmed_mm,torque_programmed_nm,power_programmed_kw");
  EXPECT_THAT(with, ContainsRegex("axis_jerk_x,0,0\\.025,[^\n]*,25,50,"));
  EXPECT_THAT(with, ContainsRegex("programmed_feed,0,0\\.05,[^\n]*,50,50,"));
  EXPECT_THAT(text(8), HasSubstr("programmed_feed,0,,,,,,,,,,,,\n"));
}

}  // namespace
}  // namespace feedscope
