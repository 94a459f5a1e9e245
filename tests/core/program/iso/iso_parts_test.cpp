#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "core/program/iso/geometry/coordinates.h"
#include "core/program/iso/geometry/kept_modes.h"
#include "core/program/iso/geometry/targets.h"
#include "core/program/iso/language/variables.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::iso {
namespace {

/// What parts of the reader work on, to test them alone.
struct PartBench {
  void set(char letter, double value) {
    Word word;
    word.letter = letter;
    word.value = value;
    word.column = 1;
    context.words.set(word);
  }

  ReadOptions options;
  ReadProgram program;
  DiagnosticLog log;
  PathWriter path{program, log};
  LineRunner lines{std::make_shared<const SourceText>("test.nc", "G0 X1\n"), options, log};
  SubprogramFiles files{{}};
  ToolRack tools{options, files, program, path, lines, log};
  OtherAxes other_axes{program, lines, log, options};
  UnitTracker unit{options, program};
  Machining machining{options, log, path, lines, tools, other_axes, unit};
  Context context{machining, Dialect::fanuc};
};

TEST(IsoTargets, AddToThePlaceWhereDistancesAreProgrammed) {
  PartBench bench;
  Targets targets(bench.context);
  bench.set('X', 3);
  EXPECT_EQ(targets.target_from({1, 2, 0}), Vec3(3, 2, 0));
  bench.context.modal.incremental = true;
  EXPECT_EQ(targets.target_from({1, 2, 0}), Vec3(4, 2, 0));
}

TEST(IsoTargets, AreInchesWhereTheProgramHasThem) {
  PartBench bench;
  Targets targets(bench.context);
  bench.context.modal.inch = true;
  bench.set('Y', 2);
  EXPECT_DOUBLE_EQ(targets.target_from(Vec3::Zero()).y(), 50.8);
}

TEST(IsoTargets, KeepRadiusAndAngleOfG16FromBlockToBlock) {
  PartBench bench;
  Targets targets(bench.context);
  targets.set_polar(true);
  bench.set('X', 10);
  bench.set('Y', 90);
  EXPECT_TRUE(targets.target().isApprox(Vec3(0, 10, 0), 1e-12));
  bench.context.words.clear();
  bench.set('Y', 180);
  EXPECT_TRUE(targets.target().isApprox(Vec3(-10, 0, 0), 1e-12));
}

TEST(IsoVariables, OfACallAreItsOwn) {
  Variables variables(Dialect::fanuc);
  variables.set(1, 5);
  variables.set(100, 7);
  variables.enter(variables.no_arguments());
  EXPECT_NE(variables.get(1), 5);
  EXPECT_EQ(variables.get(100), 7);
  variables.set(1, 6);
  variables.leave();
  EXPECT_EQ(variables.get(1), 5);
}

TEST(IsoVariables, WithAnUnderscoreAreKnownInEveryCall) {
  Variables variables(Dialect::linuxcnc);
  variables.set("_shared", 1);
  variables.set("own", 2);
  variables.enter(variables.no_arguments());
  EXPECT_EQ(variables.get("_shared"), 1);
  EXPECT_EQ(variables.get("own"), std::nullopt);
}

TEST(IsoKeptModes, AreRestoredByM72) {
  PartBench bench;
  Targets targets(bench.context);
  Coordinates coordinates(bench.context, targets);
  KeptModes modes(bench.context, coordinates);
  bench.path.set_feed(3);
  modes.run(70, 1);
  bench.context.modal.incremental = true;
  bench.path.set_feed(5);
  modes.run(72, 1);
  EXPECT_FALSE(bench.context.modal.incremental);
  EXPECT_EQ(bench.path.feed(), 3);
}

TEST(IsoKeptModes, ThatNothingHasKeptAreReported) {
  PartBench bench;
  Targets targets(bench.context);
  Coordinates coordinates(bench.context, targets);
  KeptModes(bench.context, coordinates).run(72, 1);
  EXPECT_EQ(bench.log.take().front().code, "modal-state");
}

}  // namespace
}  // namespace feedscope::iso
