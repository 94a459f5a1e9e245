#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "core/base/error.h"
#include "core/export/export.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* csv_header =
    "time_s,path_mm,line,x_mm,y_mm,z_mm,feed_mm_min,programmed_feed_mm_min,vx_mm_min,vy_mm_min,vz_mm_min,"
    "ax_m_s2,ay_m_s2,az_m_s2,jx_m_s3,jy_m_s3,jz_m_s3,at_m_s2,jt_m_s3,cause\n";

/// 0.02 s up by jerk 1000 mm/s3 times -1 in X and steady after it for 0.03 s, from line 7.
Trajectory ramp_and_cruise() {
  BlendedPath path;
  PathElement line;
  line.start = Vec3(1, 2, 3);
  line.length = 10;
  line.end = Vec3(-9, 2, 3);
  path.elements = {line};
  return Trajectory(std::move(path),
                    {{0, 0, 5, 0, 1000, 0, {CauseKind::axis_jerk, 0}, Law::path_length},
                     {0.02, 1, 10, 0, 0, 0, {CauseKind::programmed_feed, -1}, Law::path_length}},
                    0.05, {}, {7}, {10}, {false});
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
  EXPECT_EQ(csv(ramp_and_cruise(), 0.02),
            std::string(csv_header) +
                "0,0,7,1,2,3,300,600,-300,0,0,0,0,0,-1,0,0,0,1,axis_jerk_x\n"
                "0.02,1,7,0,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed\n"
                "0.04,1.2,7,-0.2,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed\n"
                "0.05,1.3,7,-0.3,2,3,600,600,-600,0,0,0,0,0,0,0,0,0,0,programmed_feed\n");
}

TEST(Csv, DoesNotRepeatTheEndThatFallsOnAStep) {
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.05)), 2U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.01)), 6U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 0.05 / 3)), 4U);
  EXPECT_EQ(rows(csv(ramp_and_cruise(), 1)), 2U);
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
  BlendedPath path;
  path.elements.resize(2);
  path.elements[0].kind = ElementKind::blend;
  path.elements[1].kind = ElementKind::arc;
  BlendRecord blend;
  blend.line = 12;
  blend.element = 0;
  blend.corner = Vec3(1, -2, 3.5);
  blend.turn = std::acos(-1.0) / 4;
  blend.transition = 0.5;
  blend.epsilon = 0.08;
  blend.length = 0.9;
  blend.min_radius = 0.25;
  blend.entry_speed = 10;
  blend.exit_speed = 20;
  BlendRecord arc = blend;
  arc.element = 1;
  arc.line = 13;
  std::ostringstream out;
  write_blends(out, Trajectory(std::move(path), {}, 0, {blend, arc}, {1, 1}, {1, 1}, {false, false}));
  EXPECT_EQ(out.str(),
            "line,kind,x_mm,y_mm,z_mm,turn_deg,transition_mm,epsilon_mm,length_mm,min_radius_mm,"
            "entry_feed_mm_min,exit_feed_mm_min\n"
            "12,cubic,1,-2,3.5,45,0.5,0.08,0.9,0.25,600,1200\n"
            "13,arc,1,-2,3.5,45,0.5,0.08,0.9,0.25,600,1200\n");
}

}  // namespace
}  // namespace feedscope
