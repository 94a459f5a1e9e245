#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/program/program.h"
#include "tests/support/folders.h"

namespace feedscope {
namespace {

const std::filesystem::path corpus = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus";

/// How many motions more than the plain scan of words behind FACTS.json counts.
struct Extra {
  int rapids = 0;
  int lines = 0;
  int arcs = 0;
  int dwells = 0;
};

/// The extent of an axis where it is not the scan's [mm]; no extent where min > max.
struct Extent {
  char axis = 'X';
  double min = 0;
  double max = 0;
};

/// A program, and where and why the reader differs from the scan, which runs no loop, call, cycle or frame.
struct CorpusCase {
  const char* file;
  Extra extra = {};
  const char* reason = "";
  bool errors = false;
  std::vector<Extent> extents = {};
};

void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.file;
}

const std::vector<CorpusCase>& corpus_cases() {
  constexpr double none = 1e99;
  static const std::vector<CorpusCase> cases = {
      {"grbl_hobby/Michael-F-Bryan__estlcam_circle_a.gcode"},
      {"grbl_hobby/Michael-F-Bryan__samples.ngc",
       {-2, 9, 120},
       "a collection of words with faults on purpose; a NURBS as arcs, polar words, a probing word whose "
       "Z-99999 inch is read as a point on the way",
       true,
       {{'X', -25.4, 4572}, {'Y', -750.824, 4572}, {'Z', -2539974.6, 762}}},
      {"grbl_hobby/cncjs__Circle_Diamond_Square_Calibration.gcode",
       {0, 5, -5},
       "five arcs with wrong centres (radius 29 against 27.6 mm) become lines",
       true},
      {"grbl_hobby/cncjs__helical-thread-milling.gcode",
       {},
       "G42; its first cut starts at the assumed start, which then counts for Z",
       true,
       {{'Z', -16.5938, 0}}},
      {"grbl_hobby/cncjs__tball-pocket.gcode"},
      {"grbl_hobby/fragmuffin__plug6a.tap",
       {1},
       "the scan leaves out a G0 that shares its block with G80; Z is never programmed and stays 0",
       false,
       {{'Z', 0, 0}}},
      {"grbl_hobby/synthetos__xyzcurve.txt", {}, "no feed at all", true},
      {"grbl_hobby/vilemduha__Parallel.gcode"},
      {"grbl_hobby/vilemduha__RampIn.gcode"},
      {"grbl_hobby/winder__Gates_combined_R12.nc"},
      {"grbl_hobby/winder__Helix.input.nc", {}, "no F", true},
      {"grbl_hobby/winder__arc_rword_test.gcode"},
      {"grbl_hobby/winder__comments.gcode"},
      {"grbl_hobby/winder__no_spaces.gcode", {0, 0, 0, 1}, "one G4"},
      {"grbl_hobby/winder__stress_test.gcode"},
      {"heidenhain/aamorim1913__CIRSTUD.h",
       {-2, 1, -1},
       "two rapids to M91; its circle starts where the operator has put the tool, in X0 here, the centre",
       true,
       {{'X', 0, 0}}},
      {"heidenhain/aamorim1913__Top-light-cover_11.h",
       {78, 40, 0, 4},
       "M91 left out, 4 holes of cycle 1 added, down to 31.801 mm",
       false,
       {{'Z', -31.801, 25}}},
      {"heidenhain/aamorim1913__basemach_11.h", {104, 53, 0, 11}, "M91 left out, 16 holes of cycle 1 added"},
      {"heidenhain/aamorim1913__boss_12.h",
       {-3, -4, 0, 4},
       "M91 and lines that only switch; a datum shift by X-189.044 Z-287.724",
       false,
       {{'X', -192.044, -63.662}, {'Z', -287.729, -167.724}}},
      {"iso_fanuc/CauldronDevelopmentLLC__flower_mold.nc"},
      {"iso_fanuc/CauldronDevelopmentLLC__tiger.nc"},
      {"iso_fanuc/LinuxCNC__M98-loops.ngc",
       {26, 12},
       "12 holes by G81 in called rows, R and Z from the level before with G91",
       false,
       {{'X', 0, 10}, {'Z', -0.5, 0.5}}},
      {"iso_fanuc/MaestroFusion360__BOTTLE.NC", {}, "its centres are positions without G90.1, recognised"},
      {"iso_fanuc/MaestroFusion360__G17_18_19.NC"},
      {"iso_fanuc/MaestroFusion360__G83.NC",
       {275, 132, 0, 12},
       "12 holes of 11 pecks; G28 stays where it is"},
      {"iso_fanuc/MaestroFusion360__correction_fanuc.nc", {}, "G41 with a radius that is not known", true},
      {"iso_fanuc/MaestroFusion360__macro_boss_milling.nc",
       {0, 0, 199},
       "200 turns of a helix in a loop and one circle, of which the scan counts two",
       true,
       {{'Y', 50, 100}, {'Z', -50, 100}}},
      {"iso_fanuc/MaestroFusion360__subprogram.nc",
       {27, 78, 40},
       "a contour called ten times, a bore three times, each deeper than the last",
       false,
       {{'Z', -6.35, 25.4}}},
      {"iso_fanuc/fragmuffin__Clamp.nc"},
      {"linuxcnc/CauldronDevelopmentLLC__locket_outside.ngc"},
      {"linuxcnc/CauldronDevelopmentLLC__tiny_cat_outline.ngc",
       {},
       "its depth, Z#2, is a variable",
       false,
       {{'Z', -1.5, 5}}},
      {"linuxcnc/LinuxCNC__Cereal.ngc"},
      {"linuxcnc/LinuxCNC__LHchips4.ngc"},
      {"linuxcnc/LinuxCNC__bad-arc.medium.metric.center-format.ngc",
       {0, 1, -1},
       "an arc that is wrong on purpose becomes a line",
       true},
      {"linuxcnc/LinuxCNC__blur_torus.ngc"},
      {"linuxcnc/LinuxCNC__cam.ngc",
       {0, 49, 237},
       "loops over depths and radii; G42 with the machine's tool table",
       true,
       {{'X', -14.8844, 75}, {'Y', -15.175, 4.16567}, {'Z', -7.12, 75}}},
      {"linuxcnc/LinuxCNC__cap.ngc"},
      {"linuxcnc/LinuxCNC__ccomp-mill-line-arc-entry.ngc",
       {},
       "G41 with the machine's tool table; Z is never programmed",
       true,
       {{'Z', 0, 0}}},
      {"linuxcnc/LinuxCNC__cds.ngc"},
      {"linuxcnc/LinuxCNC__comp-g1.ngc", {}, "G41 with the machine's tool table", true},
      {"linuxcnc/LinuxCNC__contour.ngc"},
      {"linuxcnc/LinuxCNC__flowsnake.ngc",
       {0, 3 * 1024 - 1, 0},
       "three curves of five levels, each level in four parts",
       false,
       {{'X', 0.25, 3.75}, {'Y', -0.010363, 3.95}}},
      {"linuxcnc/LinuxCNC__g18-g98-g81.ngc",
       {25, 9},
       "nine holes in the plane ZX, six of them in incremental rows",
       false,
       {{'X', 0, 812.8}, {'Y', -25.4, 127}}},
      {"linuxcnc/LinuxCNC__inverse.ngc",
       {2, 18, 10},
       "a contour three times, on it and 0.2 inch beside it on both sides, arcs at its outside corners and "
       "at an entry",
       false,
       {{'X', -30.48, 30.48}}},
      {"linuxcnc/LinuxCNC__line-contouring-xz.ngc"},
      {"linuxcnc/LinuxCNC__nurbs_G5_Curva_Delfino.ngc", {0, 2, 317}, "33 splines as arcs"},
      {"linuxcnc/LinuxCNC__polar.ngc",
       {53, 26},
       "26 holes: by polar words on two circles and along a line at 33 degrees",
       false,
       {{'X', -49.935, 127.813}, {'Y', -54.9926, 83.003}, {'Z', -12.7, 5.08}}},
      {"linuxcnc/LinuxCNC__spiral-circular-segments.ngc"},
      {"linuxcnc/LinuxCNC__trochoidal.ngc"},
      {"linuxcnc/LinuxCNC__zigzag_0.002_0.0005.ngc"},
      {"print3d/cncjs__part.gcode",
       {},
       "its first feed move starts at the assumed start, which then counts",
       false,
       {{'X', 0, 122.5362}, {'Y', 0, 122.511}, {'Z', 0, 19.75}}},
      {"sinumerik/121philip__CAM_TEST.MPF"},
      {"sinumerik/ElMoe__Keychain_Schluesselanhaenger.mpf",
       {2, 1},
       "one hole by CYCLE81, to its depth",
       false,
       {{'Z', -6.1835, 16}}},
      {"sinumerik/MaestroFusion360__contur_2d_sin840d.mpf",
       {},
       "G41 and G42 with a tool whose radius the program does not give",
       true},
      {"sinumerik/MaestroFusion360__macro_drilling.mpf",
       {29, 10},
       "ten holes in a loop, each two rapids to its place, drilled by CYCLE81 without a feed and with one "
       "height of "
       "retracting and of safety, to which a rapid is none",
       true,
       {{'X', -95.1057, 95.1057}, {'Y', -100, 100}, {'Z', -20, 20}}},
      {"sinumerik/deathaxe__example.mpf", {}, "parameters of PROC are zero"},
      {"sinumerik/deathaxe__syntax_test_din.spf",
       {-2, 3, -3},
       "words to test an editor by, with faults on purpose; arcs that are none become lines",
       true,
       {{'Y', 0, 4.66541}, {'Z', 0, 400}}},
      {"sinumerik/deathaxe__syntax_test_goto.spf",
       {},
       "jumps to labels that are not there, no motion",
       true,
       {{'X', none, -none}, {'Y', none, -none}, {'Z', none, -none}}},
  };
  return cases;
}

TEST(Corpus, TheTableNamesEveryFile) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (entry.is_regular_file() && entry.path().parent_path() != corpus) {
      files.insert(std::filesystem::relative(entry.path(), corpus).string());
    }
  }
  std::set<std::string> named;
  for (const CorpusCase& c : corpus_cases()) {
    named.insert(c.file);
  }
  EXPECT_EQ(named, files);
}

class CorpusFacts : public testing::TestWithParam<CorpusCase> {};

/// FACTS.json names motions as the dialect does.
int fact_count(const nlohmann::json& facts, const std::vector<const char*>& names) {
  int sum = 0;
  for (const char* const name : names) {
    sum += facts.at("motion").value(name, 0);
  }
  return sum;
}

/// Of places along the arcs, which FACTS.json leaves out: it scans the programmed points.
Bounds sampled_arcs(const ReadProgram& program) {
  constexpr int samples = 2000;
  Bounds bounds;
  Vec3 start = Vec3::Zero();
  for (const MotionBlock& block : program.motions) {
    if (block.motion == Motion::arc) {
      const ArcWords& arc = program.arcs[static_cast<std::size_t>(block.arc)];
      const auto across = [&](const Vec3& v) -> Vec3 { return v - arc.axis.dot(v) * arc.axis; };
      const Vec3 from = across(start - arc.center);
      const Vec3 to = across(block.target - arc.center);
      double sweep = std::atan2(arc.axis.dot(from.cross(to)), from.dot(to));
      sweep += sweep < 0 ? 2 * std::numbers::pi : 0;
      sweep =
          (arc.turns >= 1 && (to - from).norm() < same_point ? 0 : sweep) + 2 * std::numbers::pi * arc.turns;
      const Vec3 rise = arc.axis.dot(block.target - start) * arc.axis;
      for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples;
        const double angle = share * sweep;
        bounds.add(start - from + from * std::cos(angle) + arc.axis.cross(from) * std::sin(angle) +
                   share * rise);
      }
    }
    start = block.motion == Motion::dwell ? start : block.target;
  }
  return bounds;
}

void expect_extent(const ReadProgram& program, const Bounds& arcs, const nlohmann::json& facts,
                   const CorpusCase& expected, int axis) {
  const char letter = "XYZ"[axis];
  const auto other = std::find_if(expected.extents.begin(), expected.extents.end(),
                                  [&](const Extent& extent) { return extent.axis == letter; });
  const auto scanned = facts.value("bbox_mm", nlohmann::json::object());
  const std::string name(1, letter);
  ASSERT_TRUE(other != expected.extents.end() || scanned.contains(name)) << letter << " is not scanned";
  const bool from_table = other != expected.extents.end();
  double min = from_table ? other->min : scanned[name][0].get<double>();
  double max = from_table ? other->max : scanned[name][1].get<double>();
  if (min > max) {
    EXPECT_GT(program.bounds.min[axis], program.bounds.max[axis]) << letter;
    return;
  }
  min = std::min(min, arcs.min[axis]);
  max = std::max(max, arcs.max[axis]);
  EXPECT_NEAR(program.bounds.min[axis], min, 1e-3) << letter;
  EXPECT_NEAR(program.bounds.max[axis], max, 1e-3) << letter;
}

/// What the words of a block say, though its path is not known; none of those that move to the machine
/// position.
std::optional<Motion> written_motion(const ReadProgram& program, const MotionBlock& block) {
  if (block.motion != Motion::dwell || block.pause == Pause::dwell) {
    return block.motion;
  }
  const std::string line(program.source->line(block.line));
  const bool to_machine = std::regex_search(line, std::regex("G0*(28|30|53|74|75|153)|SUPA|M9[12]|MB ?MAX"));
  return block.pause != Pause::machine_move || to_machine ? std::nullopt
         : block.feed > 0                                 ? std::optional(Motion::line)
                                                          : std::optional(Motion::rapid);
}

TEST_P(CorpusFacts, MotionsArcsAndExtentAgreeOrTheReasonIsKnown) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const CorpusCase& expected = GetParam();
  const auto facts = nlohmann::json::parse(std::ifstream(corpus / "FACTS.json"))[expected.file];
  const ReadProgram program =
      read_program(std::make_shared<const SourceText>(SourceText::from_file(corpus / expected.file)));
  const auto count = [&](Motion motion) {
    return static_cast<int>(
        std::count_if(program.motions.begin(), program.motions.end(),
                      [&](const MotionBlock& block) { return written_motion(program, block) == motion; }));
  };
  EXPECT_EQ(program.source->line_count(), facts["lines"].get<unsigned>());
  EXPECT_EQ(count(Motion::rapid), fact_count(facts, {"G0", "L_FMAX"}) + expected.extra.rapids);
  EXPECT_EQ(count(Motion::line), fact_count(facts, {"G1", "L"}) + expected.extra.lines);
  EXPECT_EQ(count(Motion::arc), fact_count(facts, {"G2", "G3", "C"}) + expected.extra.arcs);
  EXPECT_EQ(count(Motion::dwell), expected.extra.dwells);
  EXPECT_EQ(has_errors(program.diagnostics), expected.errors);
  EXPECT_LT(program.diagnostics.size(), 500U);
  const Bounds arcs = sampled_arcs(program);
  for (int axis = 0; axis < 3; ++axis) {
    expect_extent(program, arcs, facts, expected, axis);
  }
  if (HasNonfatalFailure()) {
    ADD_FAILURE() << expected.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(All, CorpusFacts, testing::ValuesIn(corpus_cases()));

TEST(Corpus, CentresThatFitAsPositionsOnlyAreTakenSo) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const ReadProgram bottle = read_program(std::make_shared<const SourceText>(
      SourceText::from_file(corpus / "iso_fanuc" / "MaestroFusion360__BOTTLE.NC")));
  EXPECT_EQ(std::count_if(bottle.diagnostics.begin(), bottle.diagnostics.end(),
                          [](const Diagnostic& diagnostic) { return diagnostic.code == "arc-centers"; }),
            1);
}

}  // namespace
}  // namespace feedscope
