#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/program/program.h"

namespace feedscope {
namespace {

const std::filesystem::path corpus =
    std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus" / "sinumerik";

/// Motions, and how they differ from the plain scan of words behind FACTS.json, which runs no loop or cycle.
struct CorpusCase {
  const char* file;
  int extra_rapids = 0;
  int extra_lines = 0;
  bool errors = false;
  const char* reason = "";
};

void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.file;
}

class SinumerikCorpus : public testing::TestWithParam<CorpusCase> {};

TEST_P(SinumerikCorpus, MotionsAgreeWithTheFactsOrTheReasonIsKnown) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const CorpusCase& expected = GetParam();
  const auto facts = nlohmann::json::parse(
      std::ifstream(corpus.parent_path() / "FACTS.json"))[std::string("sinumerik/") + expected.file];
  const Program program =
      read_program(std::make_shared<const SourceText>(SourceText::from_file(corpus / expected.file)));
  const auto count = [&](Motion motion) {
    return static_cast<int>(std::count_if(program.motions.begin(), program.motions.end(),
                                          [&](const MotionBlock& block) { return block.motion == motion; }));
  };
  const auto fact = [&](const char* key) { return facts["motion"].value(key, 0); };
  EXPECT_EQ(program.dialect, Dialect::sinumerik);
  EXPECT_EQ(count(Motion::rapid), fact("G0") + expected.extra_rapids) << expected.reason;
  EXPECT_EQ(count(Motion::line), fact("G1") + expected.extra_lines) << expected.reason;
  EXPECT_EQ(count(Motion::arc), fact("G2") + fact("G3")) << expected.reason;
  EXPECT_EQ(has_errors(program.diagnostics), expected.errors) << expected.reason;
}

INSTANTIATE_TEST_SUITE_P(
    Programs, SinumerikCorpus,
    testing::Values(CorpusCase{"121philip__CAM_TEST.MPF"},
                    CorpusCase{.file = "ElMoe__Keychain_Schluesselanhaenger.mpf",
                               .extra_rapids = 2,
                               .extra_lines = 1,
                               .reason = "one hole by CYCLE81"},
                    CorpusCase{.file = "MaestroFusion360__contur_2d_sin840d.mpf",
                               .errors = true,
                               .reason = "G41 and G42 with a tool whose radius the program does not give"},
                    CorpusCase{.file = "MaestroFusion360__macro_drilling.mpf",
                               .extra_rapids = 38,
                               .extra_lines = 10,
                               .errors = true,
                               .reason = "ten holes in a loop, each two rapids to its place, drilled by "
                                         "CYCLE81 without a feed"},
                    CorpusCase{.file = "deathaxe__example.mpf", .reason = "parameters of PROC are zero"}));

}  // namespace
}  // namespace feedscope
