#include "core/analysis/notes/ignored_path_control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/program/read_text.h"
#include "tests/support/english.h"

namespace feedscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A line under the words of a Sinumerik program.
std::vector<std::string> ignored_of(const std::string& words, const std::string& model,
                                    std::vector<std::string> assignments = {}) {
  const ReadProgram program = read_text(words + "\nG1 X10 F1000\nX20 Y5\n", {.dialect = Dialect::sinumerik});
  SetupRequest request;
  request.model = model;
  request.assignments = std::move(assignments);
  return in_english(ignored_path_control(build_toolpath(program), make_setup(request)));
}

TEST(Unfollowed, NothingIsSaidOfAProgramThatAsksForNothing) {
  for (const ControlModel* model : all_models()) {
    EXPECT_THAT(ignored_of("G64", model->info().id), IsEmpty()) << model->info().id;
  }
}

TEST(Unfollowed, TolerancesNeedAModelWithBlends) {
  EXPECT_THAT(ignored_of("G642 CTOL=0.02", "cam"), ElementsAre(HasSubstr("Tolerances")));
  EXPECT_THAT(ignored_of("G641 ADIS=0.5", "tapie"), ElementsAre(HasSubstr("blend distances")));
  EXPECT_THAT(ignored_of("G642 CTOL=0.02", "essid"), IsEmpty());
}

TEST(Unfollowed, CompactionNeedsAModelThatJoinsBlocks) {
  EXPECT_THAT(ignored_of("COMPCAD", "ward"), ElementsAre(HasSubstr("short blocks are not joined")));
  EXPECT_THAT(ignored_of("COMPCAD", "essid"), IsEmpty());
  EXPECT_THAT(ignored_of("COMPCAD", "msaddek", {"compaction_mm=5"}), IsEmpty());
  EXPECT_THAT(ignored_of("COMPCAD", "msaddek", {"compaction_mm=0"}), IsEmpty());
  EXPECT_THAT(ignored_of("COMPOF", "essid"), IsEmpty());
}

/// Q of G64 asks for no curves; the setting lays them all the same.
TEST(Unfollowed, CompactionIsFollowedWhereTheCompressorIsOnEverywhere) {
  const Toolpath path =
      build_toolpath(read_text("G64 P0.01 Q0.01\nG1 X10 F1000\nX20 Y5\n", {.dialect = Dialect::iso}));
  const auto ignored = [&](const std::string& compressor) {
    SetupRequest request;
    request.model = "essid";
    request.assignments = {"compressor=" + compressor};
    return in_english(ignored_path_control(path, make_setup(request)));
  };
  EXPECT_THAT(ignored("program"), ElementsAre(HasSubstr("short blocks are not joined")));
  EXPECT_THAT(ignored("on"), IsEmpty());
}

/// They select data of the control: what a run makes of one is what it makes of the other.
TEST(Unfollowed, MachiningModesChangeNothing) {
  const auto said = [](const std::string& text, Dialect dialect, const std::string& model) {
    const LoadedProgram program =
        load_program(std::make_shared<const SourceText>("f", text), nullptr, {.dialect = dialect});
    SetupRequest request;
    request.model = model;
    return in_english(ignored_path_control(program, make_setup(request)));
  };
  const std::string move = "\nG1 X10 F1000\nX20 Y5\n";
  EXPECT_THAT(said("CYCLE832(0.01,_ROUGH,1)" + move, Dialect::sinumerik, "essid"),
              ElementsAre(HasSubstr("machining mode")));
  EXPECT_THAT(said("CYCLE832(0.01,_FINISH,1)" + move, Dialect::sinumerik, "essid"),
              ElementsAre(HasSubstr("machining mode")));
  EXPECT_THAT(said("CYCLE832(0,_OFF,1)" + move, Dialect::sinumerik, "essid"), IsEmpty());
  EXPECT_THAT(said("G187 P1" + move, Dialect::fanuc, "essid"), ElementsAre(HasSubstr("machining mode")));
  EXPECT_THAT(said("G187 E0.02" + move, Dialect::fanuc, "essid"), IsEmpty());
  EXPECT_THAT(said("G5.1 Q1 R5" + move, Dialect::fanuc, "essid"), ElementsAre(HasSubstr("machining mode")));
  EXPECT_THAT(
      said("0 BEGIN PGM A MM\n1 CYCL DEF 32.0 TOLERANZ\n2 CYCL DEF 32.1 T0.01\n3 CYCL DEF 32.2 HSC-MODE:1\n"
           "4 L X+10 R0 F1000\n5 L X+20 Y+5\n6 END PGM A MM\n",
           Dialect::heidenhain, "essid"),
      ElementsAre(HasSubstr("machining mode")));
  EXPECT_THAT(said("G187 P1" + move, Dialect::fanuc, "cam"), IsEmpty()) << "it has no acceleration to choose";
}

TEST(Unfollowed, AccelerationNeedsAModelWithRamps) {
  EXPECT_THAT(ignored_of("BRISK", "essid"), IsEmpty());
  EXPECT_THAT(ignored_of("BRISK", "ward"), ElementsAre(HasSubstr("BRISK")));
  EXPECT_THAT(ignored_of("DRIVE", "essid"), ElementsAre(HasSubstr("simulated as SOFT")));
  EXPECT_THAT(ignored_of("DRIVE", "cam"), IsEmpty());
  EXPECT_THAT(ignored_of("SOFT", "ward"), IsEmpty());
}

TEST(Unfollowed, NoModelHasFollowingErrors) {
  EXPECT_THAT(ignored_of("FFWOF", "ward"), ElementsAre(HasSubstr("lag")));
  EXPECT_THAT(ignored_of("FFWON", "ward"), IsEmpty());
}

TEST(Unfollowed, CurvesRunAsArcsInModelsWithRamps) {
  const auto said = [](const std::string& motion, const std::string& model) {
    const std::string text = "G64 G90 F1000\nG1 X0 Y0\n" + motion + " X10 Y5\nX20 Y0\nX30 Y5\n";
    const LoadedProgram program =
        load_program(std::make_shared<const SourceText>(SourceText("spline.mpf", text)), nullptr,
                     {.dialect = Dialect::sinumerik});
    SetupRequest request;
    request.model = model;
    return in_english(ignored_path_control(program, make_setup(request)));
  };
  for (const ControlModel* model : all_models()) {
    const std::string& id = model->info().id;
    EXPECT_THAT(said("G1", id), IsEmpty()) << id;
    const bool curves = model->guarantees(make_setup({"", id, {}}).settings).lays_curves;
    if (id == "cam" || curves || model->info().jumps_in_corners) {  // on curves, or no jerk is limited
      EXPECT_THAT(said("CSPLINE", id), IsEmpty());
    } else {
      EXPECT_THAT(said("CSPLINE", id), ElementsAre(HasSubstr("2.4 times"))) << id;
    }
  }
}

TEST(Unfollowed, IsSaidOnceInAFixedOrder) {
  EXPECT_THAT(ignored_of("FFWOF DRIVE COMPCAD\nG1 X1 F100\nCOMPCURV\nG1 X2", "gassara"),
              ElementsAre(HasSubstr("Compaction"), HasSubstr("DRIVE"), HasSubstr("Feed-forward")));
}

}  // namespace
}  // namespace feedscope
