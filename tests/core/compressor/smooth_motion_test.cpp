#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/analysis/run/run.h"
#include "core/analysis/run/run_stages.h"

namespace feedscope {
namespace {

Run simulated(const std::string& text, const std::string& model, double tolerance,
              std::vector<std::string> assignments) {
  SetupRequest request;
  request.machine = "dmg-mori-evo40";
  request.model = model;
  request.assignments = std::move(assignments);
  Setup setup = make_setup(request);
  set_tolerance(setup, tolerance);
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("dense.nc", text));
  return simulate_motion(program, setup);
}

double time_of(const std::string& text, const std::string& model, double tolerance,
               const std::string& compressor) {
  return simulated(text, model, tolerance, {"compressor=" + compressor}).trajectory->duration();
}

std::string point(double x, double y) {
  return fmt::format("X{:.4f} Y{:.4f}\n", x, y);
}

/// A line, a full circle about the origin, and a line again, the circle as `count` chords or one arc.
std::string circle(double radius, double feed, int count) {
  std::string text = fmt::format("G21 G90 G17\nG0 X{0} Y-60\nG1 X{0} Y0 F{1}\n", radius, feed);
  if (count == 0) {
    text += fmt::format("G3 X{0} Y0 I-{0} J0\nG1 ", radius);
  }
  for (int i = 1; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    text += point(radius * std::cos(angle), radius * std::sin(angle));
  }
  return text + fmt::format("X{} Y60\nM30\n", radius);
}

/// Dense points along a wave, from left to right or back.
std::string wave(bool back, int count = 400) {
  std::string text =
      back ? fmt::format("G21 G90\nG0 X{} Y{:.4f}\nG1 F6000\n", 0.2 * count, 3 * std::sin(0.2 * count / 3))
           : "G21 G90\nG0 X0 Y0\nG1 F6000\n";
  for (int i = 1; i <= count; ++i) {
    const double x = 0.2 * (back ? count - i : i);
    text += point(x, 3 * std::sin(x / 3));
  }
  return text + "M30\n";
}

class WithCompressor : public ::testing::TestWithParam<const char*> {};

TEST_P(WithCompressor, ACircleOfChordsTakesTheTimeOfTheArc) {
  for (const double radius : {20.0, 40.0}) {
    const double arc = time_of(circle(radius, 1500, 0), GetParam(), 0.01, "off");
    EXPECT_NEAR(time_of(circle(radius, 1500, 400), GetParam(), 0.01, "on"), arc, 0.01 * arc) << radius;
  }
}

TEST_P(WithCompressor, ACircleOf64PointsReachesTheProgrammedFeed) {
  // Beckhoff's example: R 80 mm; its chords leave the circle by 0.096 mm.
  const feedscope::Run run = simulated(circle(80, 3000, 64), GetParam(), 0.1, {"compressor=on"});
  const double circumference = 2 * std::numbers::pi * 80;
  double slowest = 1e9;
  for (double s = 60 + 0.2 * circumference; s < 60 + 0.8 * circumference; s += 1) {
    slowest = std::min(slowest, run.trajectory->state_at_path(s).speed);
  }
  EXPECT_NEAR(slowest, 50, 0.5);
}

TEST_P(WithCompressor, TimeFallsAsTheToleranceGrows) {
  // Below the chord error it falls fast; above it, a plan takes the worst of every span, whose number
  // changes.
  constexpr double steps_of_spans = 1.035;
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {0.001, 0.002, 0.005, 0.01, 0.02, 0.05}) {
    const double time = time_of(wave(false), GetParam(), tolerance, "on");
    EXPECT_LE(time, steps_of_spans * before) << "at " << tolerance;
    before = std::min(before, time);
  }
  EXPECT_LT(before, time_of(wave(false), GetParam(), 0.05, "off"));
}

TEST_P(WithCompressor, ReversedProgramsTakeTheSameTime) {
  // Back, a rapid goes to the start first.
  const std::string text = wave(true);
  const std::string rapid = text.substr(0, text.find("G1")) + "M30\n";
  const double back = time_of(text, GetParam(), 0.01, "on") - time_of(rapid, GetParam(), 0.01, "on");
  EXPECT_NEAR(time_of(wave(false), GetParam(), 0.01, "on"), back, 0.01 * back);
}

TEST_P(WithCompressor, AStandstillSplitsTheProgram) {
  const std::string whole = wave(false);
  const auto middle = whole.find("X40.0000");
  const std::string first = whole.substr(0, middle);
  const std::string second = whole.substr(middle);
  const auto begin = first.rfind('X');
  const std::string last_point = first.substr(begin, first.find('\n', begin) - begin);
  const double split = time_of(first + "G4 P100\n" + second, GetParam(), 0.01, "on") - 0.1;
  const double apart =
      time_of(first + "M30\n", GetParam(), 0.01, "on") +
      time_of("G21 G90\nG0 " + last_point + "\nG1 F6000\n" + second, GetParam(), 0.01, "on") -
      time_of("G21 G90\nG0 " + last_point + "\nM30\n", GetParam(), 0.01, "on");
  EXPECT_NEAR(split, apart, 1e-9 * split);
}

TEST_P(WithCompressor, NoiseOfRoundingChangesNothing) {
  const auto with_noise = [](double noise) {
    std::string text = "G21 G90\nG0 X0 Y0\nG1 F6000\n";
    for (int i = 1; i <= 400; ++i) {
      const double x = 0.2 * i;
      text += fmt::format("X{:.9f} Y{:.9f}\n", x + (i % 3 - 1) * noise,
                          3 * std::sin(x / 3) + (i % 5 - 2) * noise);
    }
    return text + "M30\n";
  };
  const double time = time_of(with_noise(0), GetParam(), 0.01, "on");
  EXPECT_NEAR(time_of(with_noise(1e-9), GetParam(), 0.01, "on"), time, 1e-5 * time);
}

TEST_P(WithCompressor, FollowsTheProgramWhereItIsToldTo) {
  const auto sinumerik = [](const std::string& words) {
    std::string text = "G710 G90 G642\n" + words + "\nG0 X0 Y0\nG1 F6000\n";
    for (int i = 1; i <= 200; ++i) {
      text += fmt::format("X={:.4f} Y={:.4f}\n", 0.2 * i, 3 * std::sin(0.2 * i / 3));
    }
    return text + "M30\n";
  };
  const double off = time_of(sinumerik(""), GetParam(), 0.01, "off");
  const double on = time_of(sinumerik(""), GetParam(), 0.01, "on");
  EXPECT_LT(on, off);
  EXPECT_EQ(time_of(sinumerik(""), GetParam(), 0.01, "program"), off);
  for (const char* words : {"COMPON", "COMPCURV", "COMPCAD", "COMPSURF"}) {
    EXPECT_EQ(time_of(sinumerik(words), GetParam(), 0.01, "program"), on) << words;
    EXPECT_EQ(time_of(sinumerik(words), GetParam(), 0.01, "off"), off) << words;
  }
  EXPECT_EQ(time_of(sinumerik("COMPCAD\nCOMPOF"), GetParam(), 0.01, "program"), off);
}

INSTANTIATE_TEST_SUITE_P(Models, WithCompressor, ::testing::Values("essid", "msaddek", "optimal"));

}  // namespace
}  // namespace feedscope
