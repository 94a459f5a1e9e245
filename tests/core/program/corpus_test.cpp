#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/program/program.h"

namespace feedscope {
namespace {

const std::filesystem::path corpus = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus";

Program read_corpus(const std::string& name) {
  return read_program(std::make_shared<const SourceText>(SourceText::from_file(corpus / name)));
}

TEST(Corpus, EveryFileIsReadAndWhatCannotBeReadIsSaid) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file() || entry.path().parent_path() == corpus) {
      continue;
    }
    ++files;
    const Program program = read_corpus(std::filesystem::relative(entry.path(), corpus).string());
    EXPECT_GT(program.block_count, 0U) << entry.path();
    EXPECT_LT(program.diagnostics.size(), 500U) << entry.path();
    EXPECT_TRUE(!program.motions.empty() || !program.diagnostics.empty()) << entry.path();
  }
  EXPECT_GE(files, 50);
}

/// A program of the ISO core, and where the reader differs from the plain scan of words behind FACTS.json.
struct CorpusCase {
  const char* file;
  int extra_rapids = 0;
  int extra_lines = 0;
  int extra_arcs = 0;
  const char* reason = "";
  bool errors = false;
  const char* axes = "XYZ";  ///< whose extent is compared
};

void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.file;
}

class CorpusFacts : public testing::TestWithParam<CorpusCase> {};

TEST_P(CorpusFacts, MotionsArcsAndExtentAgree) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const CorpusCase& expected = GetParam();
  const auto facts = nlohmann::json::parse(std::ifstream(corpus / "FACTS.json"))[expected.file];
  const Program program = read_corpus(expected.file);
  const auto count = [&](Motion motion) {
    return static_cast<int>(std::count_if(program.motions.begin(), program.motions.end(),
                                          [&](const MotionBlock& block) { return block.motion == motion; }));
  };
  const auto fact = [&](const char* key) { return facts["motion"].value(key, 0); };
  EXPECT_EQ(program.source->line_count(), facts["lines"].get<unsigned>());
  EXPECT_EQ(count(Motion::rapid), fact("G0") + expected.extra_rapids) << expected.reason;
  EXPECT_EQ(count(Motion::line), fact("G1") + expected.extra_lines) << expected.reason;
  EXPECT_EQ(count(Motion::arc), fact("G2") + fact("G3") + expected.extra_arcs) << expected.reason;
  EXPECT_EQ(has_errors(program.diagnostics), expected.errors) << expected.reason;
  for (const char axis : std::string_view(expected.axes)) {
    const auto range = facts["bbox_mm"][std::string(1, axis)];
    EXPECT_NEAR(program.bounds.min[axis - 'X'], range[0].get<double>(), 1e-3) << axis;
    EXPECT_NEAR(program.bounds.max[axis - 'X'], range[1].get<double>(), 1e-3) << axis;
  }
}

INSTANTIATE_TEST_SUITE_P(
    IsoCore, CorpusFacts,
    testing::Values(
        CorpusCase{"grbl_hobby/Michael-F-Bryan__estlcam_circle_a.gcode"},
        CorpusCase{.file = "grbl_hobby/cncjs__Circle_Diamond_Square_Calibration.gcode",
                   .extra_lines = 5,
                   .extra_arcs = -5,
                   .reason = "five arcs with wrong centres (radius 29 against 27.6 mm) become lines",
                   .errors = true},
        CorpusCase{.file = "grbl_hobby/cncjs__helical-thread-milling.gcode",
                   .reason = "G42; its first cut starts at the assumed start, which then counts for Z",
                   .errors = true,
                   .axes = "XY"},
        CorpusCase{"grbl_hobby/cncjs__tball-pocket.gcode"},
        CorpusCase{.file = "grbl_hobby/fragmuffin__plug6a.tap",
                   .extra_rapids = 1,
                   .reason = "the scan leaves out a G0 that shares its block with G80; Z is never programmed",
                   .axes = "XY"},
        CorpusCase{.file = "grbl_hobby/synthetos__xyzcurve.txt", .reason = "no feed at all", .errors = true},
        CorpusCase{"grbl_hobby/vilemduha__Parallel.gcode"}, CorpusCase{"grbl_hobby/vilemduha__RampIn.gcode"},
        CorpusCase{"grbl_hobby/winder__Gates_combined_R12.nc"},
        CorpusCase{"grbl_hobby/winder__arc_rword_test.gcode"},
        CorpusCase{"grbl_hobby/winder__comments.gcode"}, CorpusCase{"grbl_hobby/winder__no_spaces.gcode"},
        CorpusCase{"grbl_hobby/winder__stress_test.gcode"},
        CorpusCase{"iso_fanuc/CauldronDevelopmentLLC__flower_mold.nc"},
        CorpusCase{"iso_fanuc/CauldronDevelopmentLLC__tiger.nc"},
        CorpusCase{"iso_fanuc/fragmuffin__Clamp.nc"}, CorpusCase{"iso_fanuc/MaestroFusion360__G17_18_19.NC"},
        CorpusCase{.file = "iso_fanuc/MaestroFusion360__BOTTLE.NC",
                   .extra_lines = 1963,
                   .extra_arcs = -1956,
                   .reason = "its centres are positions, but it lacks G90.1: most arcs become lines",
                   .errors = true,
                   .axes = ""},
        CorpusCase{"linuxcnc/CauldronDevelopmentLLC__locket_outside.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__LHchips4.ngc"}, CorpusCase{"linuxcnc/LinuxCNC__Cereal.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__blur_torus.ngc"}, CorpusCase{"linuxcnc/LinuxCNC__cap.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__cds.ngc"}, CorpusCase{"linuxcnc/LinuxCNC__contour.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__line-contouring-xz.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__spiral-circular-segments.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__trochoidal.ngc"},
        CorpusCase{"linuxcnc/LinuxCNC__zigzag_0.002_0.0005.ngc"},
        CorpusCase{.file = "print3d/cncjs__part.gcode",
                   .reason = "its first feed move starts at the assumed start, which then counts",
                   .axes = ""}));

}  // namespace
}  // namespace feedscope
