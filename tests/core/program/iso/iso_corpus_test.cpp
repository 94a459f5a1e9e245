#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/program/program.h"

namespace feedscope {
namespace {

const std::filesystem::path corpus = std::filesystem::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared" / "corpus";

/// A program with loops and calls, which the scan behind FACTS.json does not follow: counted by hand.
struct CorpusCase {
  const char* file;
  std::ptrdiff_t rapids = 0;
  std::ptrdiff_t lines = 0;
  std::ptrdiff_t arcs = 0;
  const char* reason = "";
};

void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.file;
}

class IsoCorpus : public testing::TestWithParam<CorpusCase> {};

TEST_P(IsoCorpus, LoopsAndCallsRunAsOftenAsCountedByHand) {
  if (!std::filesystem::exists(corpus)) {
    GTEST_SKIP() << "no collection of real programs at " << corpus;
  }
  const CorpusCase& expected = GetParam();
  const Program program =
      read_program(std::make_shared<const SourceText>(SourceText::from_file(corpus / expected.file)));
  const auto count = [&](Motion motion) {
    return std::count_if(program.motions.begin(), program.motions.end(),
                         [&](const MotionBlock& block) { return block.motion == motion; });
  };
  EXPECT_EQ(count(Motion::rapid), expected.rapids) << expected.reason;
  EXPECT_EQ(count(Motion::line), expected.lines) << expected.reason;
  EXPECT_EQ(count(Motion::arc), expected.arcs) << expected.reason;
  for (const Diagnostic& diagnostic : program.diagnostics) {
    for (const char* const code :
         {"unread-statement", "expression", "expression-value", "variable", "subprogram", "flow-pair",
          "jump-target", "run-limit", "call-depth", "unset-variable"}) {
      EXPECT_NE(diagnostic.code, code) << format(diagnostic, expected.file);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Macros, IsoCorpus,
                         testing::Values(CorpusCase{"linuxcnc/LinuxCNC__flowsnake.ngc", 3, 1 + 3 * 1024, 0,
                                                    "three curves of five levels, each level in four parts"},
                                         CorpusCase{"iso_fanuc/MaestroFusion360__subprogram.nc", 6 + 10 * 3,
                                                    2 + 10 * 8 + 3 * 3, 10 * 4 + 3 * 2,
                                                    "a contour ten times, a bore three times"}));

}  // namespace
}  // namespace feedscope
