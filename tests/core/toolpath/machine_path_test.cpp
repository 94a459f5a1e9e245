#include "core/toolpath/machine_path.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "tests/core/toolpath/table_machine.h"

namespace feedscope {
namespace {

ReadProgram read(std::string text, Dialect dialect) {
  ReadOptions options;
  options.dialect = dialect;
  options.unit = LengthUnit::mm;
  return read_program(std::make_shared<const SourceText>("test.nc", std::move(text)), nullptr, options);
}

std::shared_ptr<const Toolpath> path_of(const std::string& text, Dialect dialect = Dialect::fanuc) {
  return std::make_shared<const Toolpath>(build_toolpath(read(text, dialect)));
}

std::vector<std::string> codes_of(const ReadProgram& program) {
  std::vector<std::string> codes;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    codes.push_back(fmt::format("{} {}", to_string(diagnostic.severity), diagnostic.code));
  }
  return codes;
}

/// "10 20 30 > 10 20 5 rapid" for every segment with a path, "~" where the path goes on elsewhere.
std::vector<std::string> text_of(const Toolpath& path) {
  const auto point = [](const Vec3& p) {
    const auto tidy = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
    return fmt::format("{} {} {}", tidy(p.x()), tidy(p.y()), tidy(p.z()));
  };
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    if (segment.kind != SegmentKind::dwell) {
      lines.push_back(fmt::format("{} > {}{}", point(path.start_of(i)), point(segment.end),
                                  segment.rapid ? " rapid" : ""));
    } else if (path.is_gap(segment) && (lines.empty() || lines.back() != "~")) {
      lines.emplace_back("~");
    }
  }
  return lines;
}

Settings machine(const Vec3& home, const Vec3& tool_change, const Vec3& part_zero) {
  Settings settings;
  for (int axis = 0; axis < 3; ++axis) {
    const char letter = "xyz"[axis];
    settings.set(fmt::format("home_{}_mm", letter), home[axis]);
    settings.set(fmt::format("tool_change_{}_mm", letter), tool_change[axis]);
    settings.set(fmt::format("part_zero_{}_mm", letter), part_zero[axis]);
  }
  return settings;
}

constexpr const char* two_holes =
    "G21 G90 G54 G17\nT1 M6\nG0 X100 Y50 S1000 M3\nG43 Z5 H1\nG1 Z-20 F200\nX150 F500\nG28 G91 Z0\nG90\nT2 "
    "M6\nG0 X0 Y0\nG43 Z5 H2\nG1 Z-5 F200\nG0 Z50\nM30\n";

TEST(MachinePath, BehindAReferencePointThePathGoesOnWhereAllAxesAreProgrammedAgain) {
  const std::vector<std::string> expected{"0 0 0 > 100 50 0 rapid",
                                          "100 50 0 > 100 50 5 rapid",
                                          "100 50 5 > 100 50 -20",
                                          "100 50 -20 > 150 50 -20",
                                          "~",
                                          "0 0 5 > 0 0 -5",
                                          "0 0 -5 > 0 0 50 rapid"};
  EXPECT_EQ(text_of(*path_of(two_holes)), expected);
}

TEST(MachinePath, AMachineThatGivesItsHomeHasTheWholePath) {
  const auto run =
      on_machine(path_of(two_holes), Machine(), machine({0, 0, 500}, {0, 0, 0}, {-300, -200, 100}));
  const std::vector<std::string> expected{"0 0 0 > 100 50 0 rapid",        "100 50 0 > 100 50 5 rapid",
                                          "100 50 5 > 100 50 -20",         "100 50 -20 > 150 50 -20",
                                          "150 50 -20 > 150 50 400 rapid", "150 50 400 > 0 0 400 rapid",
                                          "0 0 400 > 0 0 5 rapid",         "0 0 5 > 0 0 -5",
                                          "0 0 -5 > 0 0 50 rapid"};
  EXPECT_EQ(text_of(*run), expected);
  EXPECT_EQ(run->bounds.max.z(), 400);
}

TEST(MachinePath, AZeroPointOfTheProgramStandsForThatOfTheMachine) {
  const auto path = path_of("G21 G10 L2 P1 X-300 Y-200 Z100\nG54\nG0 X1 Y2 Z3\nG91 G28 Z0\nG90 G1 Z5 F100\n");
  EXPECT_EQ(text_of(*path), (std::vector<std::string>{"0 0 0 > -299 -198 103 rapid", "~"}));
  Settings home;
  home.set("home_z_mm", 500.0);
  const std::vector<std::string> expected{
      "0 0 0 > -299 -198 103 rapid", "-299 -198 103 > -299 -198 500 rapid", "-299 -198 500 > -299 -198 105"};
  EXPECT_EQ(text_of(*on_machine(path, Machine(), home)), expected);
  home.set("part_zero_z_mm", 7.0);
  EXPECT_EQ(text_of(*on_machine(path, Machine(), home)), expected) << "that of other programs";
}

TEST(MachinePath, CountsWhatHasNoTime) {
  const auto path = path_of(std::string(two_holes).replace(0, 0, "M1\n"));
  const NotCounted all = not_counted(*path);
  EXPECT_EQ(all.tool_changes, 2U);
  EXPECT_EQ(all.spindle_starts, 1U) << "the second tool's is not programmed";
  EXPECT_EQ(all.stops, 1U);
  EXPECT_EQ(all.machine_moves, 3U);
  Settings times;
  times.set("tool_change_time_s", 4.0);
  times.set("spindle_start_time_s", 0.0);
  const auto timed = on_machine(path, Machine(), times);
  double waits = 0;
  for (const Segment& segment : timed->segments) {
    waits += segment.kind == SegmentKind::dwell ? timed->dwell_of(segment) : 0;
  }
  EXPECT_EQ(waits, 8);
  EXPECT_EQ(not_counted(*timed), (NotCounted{0, 0, 1, 3}));
  EXPECT_EQ(on_machine(path, Machine(), Settings()).toolpath, path);
}

TEST(MachinePath, CuttingFeedsOfAxesHoldForFeedsAndNotForRapids) {
  const auto path = path_of(
      "G21 G17\nG0 X10 Y0 Z0\nG1 X20 F25000\nY10\nX23 Y14\nX33 F6000\nG2 X43 Y24 J10 F25000\nG18 G2 X53 Z10 "
      "K10\n");
  Settings machine;
  machine.set("cutting_feed_x_m_min", 12.0);
  machine.set("cutting_feed_y_m_min", 8.0);
  const auto run = on_machine(path, Machine(), machine);
  std::vector<double> feeds;
  std::vector<int> axes;
  for (const Segment& segment : run->segments) {
    feeds.push_back(std::round(60 * segment.feed * 1e6) / 1e6);
    axes.push_back(segment.feed_axis);
  }
  EXPECT_EQ(feeds, (std::vector<double>{0, 12000, 8000, 10000, 6000, 8000, 12000}));
  EXPECT_EQ(axes, (std::vector<int>{-1, 0, 1, 1, -1, 1, 0})) << "-1: the feed of the program";
}

TEST(MachinePath, AFeedOverrideHoldsForFeedsAndNotForRapids) {
  const auto path = path_of("G0 X10\nG1 X20 F600\nG28 Z0\nG1 X40 F60\nM30\n");
  Settings override = machine({0, 0, 500}, {0, 0, 0}, {0, 0, 0});
  override.set("feed_override_percent", 120.0);
  const auto run = on_machine(path, Machine(), override);
  ASSERT_EQ(run->segments.size(), path->segments.size());
  for (std::size_t i = 0; i < run->segments.size(); ++i) {
    EXPECT_EQ(run->segments[i].feed > 0, path->segments[i].feed > 0);
    EXPECT_NEAR(run->segments[i].feed, 1.2 * path->segments[i].feed, 1e-12);
  }
  override.set("feed_override_percent", 50.0);
  EXPECT_NEAR(on_machine(path, Machine(), override)->segments[1].feed, 0.5 * path->segments[1].feed, 1e-12);
  Settings none;
  none.set("feed_override_percent", 100.0);
  EXPECT_EQ(on_machine(path, Machine(), none).toolpath, path);
}

/// Two faces and back; on a machine with rotary axes they are pauses that take their time.
TEST(MachinePath, CountsTurnsForTiltedPlanesThatNoAxisMakes) {
  const auto path = path_of(
      "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+50 R0 F1000\n2 PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX\n3 L X+5 "
      "Y+0 Z+1\n4 PLANE SPATIAL SPA+30 SPB+0 SPC+90 TURN FMAX\n5 L X+5 Y+5 Z+1\n6 PLANE RESET TURN FMAX\n"
      "7 L Z+100\n8 END PGM A MM\n",
      Dialect::heidenhain);
  EXPECT_EQ(not_counted(*on_machine(path, Machine(), Settings())).plane_turns, 3U);
  EXPECT_EQ(not_counted(*on_machine(path, table_machine(), Settings())).plane_turns, 0U);
}

TEST(MachinePath, ToolChangesAndSpindleStartsAreThoseThatChangeSomething) {
  const auto count = [](const char* text, Dialect dialect) { return not_counted(*path_of(text, dialect)); };
  const NotCounted fanuc = count("T1 M6\nM6\nT2 M6\nS1 M3\nM3\nM5\nM4\nG0 X1\nT2 M6\nM0\n", Dialect::fanuc);
  EXPECT_EQ(fanuc, (NotCounted{2, 2, 1, 0}));
  const NotCounted sinumerik =
      count("T=\"A\" M6\nS1 M3\nG0 X1\nM5\nT=\"B\"\nM6\nM3\nG0 X2\nM1\nM30\n", Dialect::sinumerik);
  EXPECT_EQ(sinumerik, (NotCounted{2, 2, 1, 0}));
  const NotCounted heidenhain = count(
      "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+1 R0 FMAX M3\n3 TOOL CALL S2000\n4 L X+2 R0 FMAX "
      "M13\n5 "
      "STOP\n6 TOOL CALL 2 Z\n7 L X+3 FMAX M3\n8 END PGM A MM\n",
      Dialect::heidenhain);
  EXPECT_EQ(heidenhain, (NotCounted{2, 2, 1, 0}));
}

TEST(MachinePath, ReportsAWarningAndNoError) {
  EXPECT_EQ(codes_of(read("G0 X1 Y1 Z1\nG28 G91 Z0\nG90\nG53 Y2\nG30 X0\n", Dialect::fanuc)),
            (std::vector<std::string>{"warning reference-point", "warning machine-position",
                                      "warning reference-point"}));
  EXPECT_EQ(codes_of(read("G0 X1 Y1 Z1\nSUPA Z500 D0\nG74 X1=0\nG75 FP=1 Z1=0\n", Dialect::sinumerik)),
            (std::vector<std::string>{"warning machine-position", "warning machine-position",
                                      "warning machine-position"}));
}

TEST(MachinePath, AFeedMoveAssumesWhatIsNotKnown) {
  const ReadProgram program = read("G0 X1 Y2 Z3\nG28 G91 Z0\nG90\nG1 X5 F100\nG2 X7 I1\n", Dialect::fanuc);
  EXPECT_EQ(codes_of(program),
            (std::vector<std::string>{"warning reference-point", "warning unknown-position"}));
  const auto path = std::make_shared<const Toolpath>(build_toolpath(program));
  const std::vector<std::string> expected{"0 0 0 > 1 2 0 rapid"};
  const auto lines = text_of(*path);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[1], "~");
  EXPECT_EQ(lines[2], "1 2 3 > 5 2 3");
  const auto run = on_machine(path, Machine(), machine({0, 0, 500}, {0, 0, 0}, {0, 0, 0}));
  EXPECT_EQ(text_of(*run)[1], "1 2 3 > 1 2 500 rapid");
  EXPECT_EQ(text_of(*run)[2], "~") << "how the tool comes back is not known";
}

TEST(MachinePath, ACycleReturnsToItsRetractPlaneWhereTheLevelBeforeItIsNotKnown) {
  const auto path = path_of("G0 X0 Y0 Z-20\nG28 G91 Z0\nG90\nG0 X9 Y9\nG81 Z-5 R2 F100\nX20\nG80\n");
  for (std::size_t i = 0; i < path->segments.size(); ++i) {
    const Segment& segment = path->segments[i];
    const bool across = segment.kind == SegmentKind::line && path->start_of(i).x() != segment.end.x();
    EXPECT_TRUE(!across || segment.end.x() == 9 || segment.end.z() == 2) << "segment " << i;
  }
}

TEST(MachinePath, CutterCompensationBeginsAgainBehindIt) {
  ReadOptions options;
  options.dialect = Dialect::fanuc;
  options.radii.set("1", 5);
  const ReadProgram program = read_program(
      std::make_shared<const SourceText>(
          "test.nc",
          "G0 X0 Y0 Z5\nG1 Z-1 F100\nG41 D1 X10 Y0\nX50\nG28 G91 Z0\nG90\nG0 X0 Y0\nZ5\nG1 Z-1\nX10\nX50\n"),
      nullptr, options);
  const Toolpath path = build_toolpath(program);
  for (const Segment& segment : path.segments) {
    EXPECT_TRUE(segment.end.allFinite());
  }
  EXPECT_EQ(path.segments.back().end, Vec3(50, 5, -1)) << "left of the contour";
}

/// Random programs with machine positions, and where the axes really are.
class RandomMachineProgram {
 public:
  RandomMachineProgram(std::uint32_t seed, Dialect dialect, const Vec3& home, const Vec3& change,
                       const Vec3& zero)
      : random_(seed), dialect_(dialect), home_(home - zero), change_(change - zero), zero_(zero) {
    text_ = dialect == Dialect::heidenhain ? "BEGIN PGM A MM\n" : "G90\n";
    for (int i = 0; i < 40; ++i) {
      add_line();
    }
    add_motion(7, 7, false, true);
    text_ += dialect == Dialect::heidenhain ? "END PGM A MM\n" : "M30\n";
  }

  const std::string& text() const { return text_; }
  /// Every way with a length, in order; known: the program alone says both ends.
  struct Way {
    Vec3 from, to;
    bool known = false;
  };
  const std::vector<Way>& ways() const { return ways_; }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  double coordinate() { return below(200) - 100; }

  void go(const Vec3& to, int known_after) {
    const bool known = known_ == 7 && known_after == 7;
    if ((to - at_).norm() > same_point) {
      ways_.push_back({at_, to, known});
    }
    at_ = to;
    known_ = known_after;
  }

  /// `axes`: bits; `fed`: bits that must be absolute for a feed move.
  void add_motion(int axes, int, bool rapid, bool absolute) {
    const bool german = dialect_ == Dialect::heidenhain;
    std::string line = german ? "L" : fmt::format("{} {}", absolute ? "G90" : "G91", rapid ? "G0" : "G1");
    Vec3 to = at_;
    int known = known_;
    for (int axis = 0; axis < 3; ++axis) {
      if ((axes >> axis & 1) == 0) {
        continue;
      }
      const double value = coordinate();
      line += german ? fmt::format(" {}{}{:+}", absolute ? "" : "I", "XYZ"[axis], value)
                     : fmt::format(" {}{}", "XYZ"[axis], value);
      to[axis] = absolute ? value : at_[axis] + value;
      known |= absolute ? 1 << axis : 0;
    }
    text_ += line + (german ? (rapid ? " R0 FMAX\n" : " R0 F500\n") : " F500\n");
    go(to, known);
  }

  void add_line() {
    const int axes = 1 + below(7);
    switch (below(7)) {
      case 6:
        text_ += below(2) > 0                      ? (dialect_ == Dialect::heidenhain ? "STOP\n" : "M0\n")
                 : dialect_ == Dialect::heidenhain ? "TOOL CALL 1 Z\n"
                                                   : "T1 M6\n";
        break;
      case 0:
      case 1:
        add_machine_move(axes);
        break;
      case 2:
        add_motion(7, 7, false, true);
        break;
      default:
        add_motion(axes, 0, true, below(3) > 0);
    }
  }

  void add_machine_move(int axes) {
    const int kind = dialect_ == Dialect::heidenhain ? 2 : below(3);
    const bool coordinates = kind == 2;
    const char* const words[][3] = {{"G91 G28", "G91 G30", "G90 G53 G0"}, {"G74", "G75", "G90 G0 SUPA"}};
    std::string line =
        dialect_ == Dialect::heidenhain ? "L" : words[dialect_ == Dialect::sinumerik ? 1 : 0][kind];
    Vec3 to = at_;
    for (int axis = 0; axis < 3; ++axis) {
      if ((axes >> axis & 1) == 0) {
        continue;
      }
      const double value = coordinates ? coordinate() : 0;
      line += dialect_ == Dialect::heidenhain                  ? fmt::format(" {}{:+}", "XYZ"[axis], value)
              : dialect_ == Dialect::sinumerik && !coordinates ? fmt::format(" {}1=0", "XYZ"[axis])
                                                               : fmt::format(" {}{}", "XYZ"[axis], value);
      to[axis] = coordinates ? value - zero_[axis] : (kind == 0 ? home_ : change_)[axis];
    }
    text_ += line + (dialect_ == Dialect::heidenhain ? " R0 FMAX M91\n" : "\n");
    go(to, known_ & ~axes);
  }

  std::mt19937 random_;
  Dialect dialect_;
  Vec3 home_, change_, zero_;
  Vec3 at_ = Vec3::Zero();
  int known_ = 7;
  std::string text_;
  std::vector<Way> ways_;
};

class MachineToolpathOf : public testing::TestWithParam<Dialect> {};

/// The whole path of a machine that gives its positions is where the axes are; without them it is the part of
/// it whose ends the program says.
TEST_P(MachineToolpathOf, RandomProgramsIsWhereTheAxesAre) {
  const Vec3 home(10.5, -20.5, 400.25);
  const Vec3 change(-33.5, 44.25, 350.125);
  const Vec3 zero(-300.75, -200.5, 100.25);
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    const RandomMachineProgram random(seed, GetParam(), home, change, zero);
    const auto path = path_of(random.text(), GetParam());
    const auto run = on_machine(path, Machine(), machine(home, change, zero));
    std::vector<std::string> all, known;
    const auto line = [](const Vec3& from, const Vec3& to) {
      return fmt::format("{:.4f} {:.4f} {:.4f} > {:.4f} {:.4f} {:.4f}", from.x() + 0.0, from.y() + 0.0,
                         from.z() + 0.0, to.x() + 0.0, to.y() + 0.0, to.z() + 0.0);
    };
    for (const auto& way : random.ways()) {
      all.push_back(line(way.from, way.to));
      if (way.known) {
        known.push_back(all.back());
      }
    }
    const auto lines = [&](const Toolpath& toolpath) {
      std::vector<std::string> found;
      for (std::size_t i = 0; i < toolpath.segments.size(); ++i) {
        if (toolpath.segments[i].kind == SegmentKind::line) {
          found.push_back(line(toolpath.start_of(i), toolpath.segments[i].end));
        } else if (!toolpath.is_gap(toolpath.segments[i])) {
          EXPECT_EQ(toolpath.start_of(i), toolpath.segments[i].end) << "seed " << seed << ", segment " << i;
        }
      }
      return found;
    };
    ASSERT_EQ(lines(*run), all) << "seed " << seed << "\n" << random.text();
    ASSERT_EQ(lines(*path), known) << "seed " << seed << "\n" << random.text();
    ASSERT_EQ(run->segments.size(), path->segments.size());
    ASSERT_EQ(not_counted(*run).machine_moves, 0U) << random.text();
  }
}

INSTANTIATE_TEST_SUITE_P(Dialects, MachineToolpathOf,
                         testing::Values(Dialect::fanuc, Dialect::linuxcnc, Dialect::sinumerik,
                                         Dialect::heidenhain));

}  // namespace
}  // namespace feedscope
