#include "core/load/load_model.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace feedscope {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* two_tools =
    "T1 M6\nS6000 M3\nG1 X10 F1000\nX20\nT2 M6\nX30\nS3000 M3\nX40\nM5\nX50\nM30\n";

Engagement mill(const std::string& tool, std::vector<ProgramLines> lines = {}) {
  Engagement operation;
  operation.tool = tool;
  operation.lines = std::move(lines);
  operation.diameter = 10;
  operation.teeth = 2;
  operation.radial_depth = 2;
  operation.axial_depth = 3;
  operation.material = "steel-c45";
  return operation;
}

struct Read {
  ReadProgram program;
  Toolpath path;

  explicit Read(const std::string& text, ReadOptions options = {})
      : program(read_program(std::make_shared<SourceText>("part.nc", text), nullptr, options)),
        path(build_toolpath(program)) {}
  LoadModel model(std::vector<Engagement> operations) const {
    return LoadModel({std::move(operations), {}}, program, path);
  }
  const Segment& at_line(std::uint32_t line) const {
    return *std::find_if(path.segments.begin(), path.segments.end(), [&](const Segment& segment) {
      return segment.line == line && segment.kind != SegmentKind::dwell;
    });
  }
  /// Engagement and spindle speed [1/min] of a line that moves.
  std::pair<int, double> of_line(const LoadModel& model, std::uint32_t line) const {
    const Segment& segment = at_line(line);
    const int operation = model.operation_of(segment.spindle, line);
    return {operation, operation < 0 ? 0 : std::round(60 * model.speed_of(operation, segment.spindle))};
  }
};

TEST(LoadModel, FindsTheOperationOfAToolAndItsSpeed) {
  const Read read(two_tools);
  const LoadModel model = read.model({mill("2"), mill("1")});
  EXPECT_EQ(read.of_line(model, 3), std::pair(1, 6000.0));
  EXPECT_EQ(read.of_line(model, 6), std::pair(0, 0.0)) << "the spindle stands after a tool change";
  EXPECT_EQ(read.of_line(model, 8), std::pair(0, 3000.0));
  EXPECT_EQ(read.of_line(model, 10), std::pair(0, 0.0)) << "M5";
}

TEST(LoadModel, PrefersLinesThenTheTool) {
  const Read read(two_tools);
  const LoadModel model = read.model({mill(""), mill("1"), mill("", {{4, 4}, {8, 9}})});
  EXPECT_EQ(read.of_line(model, 3).first, 1);
  EXPECT_EQ(read.of_line(model, 4).first, 2);
  EXPECT_EQ(read.of_line(model, 6).first, 0);
  EXPECT_EQ(read.of_line(model, 8).first, 2);
  EXPECT_EQ(read.of_line(model, 10).first, 0);
}

TEST(LoadModel, TakesTheOperationsSpeedWhereTheProgramGivesNone) {
  const Read silent("G1 X10 F1000\nX20 S2000\nX30\n");
  Engagement operation = mill("");
  EXPECT_EQ(silent.of_line(silent.model({operation}), 1).second, 0);
  EXPECT_EQ(silent.of_line(silent.model({operation}), 3).second, 2000) << "a program without M3";
  operation.spindle_speed = 50;
  EXPECT_EQ(silent.of_line(silent.model({operation}), 1).second, 3000);
  EXPECT_EQ(silent.of_line(silent.model({operation}), 3).second, 2000);
}

TEST(LoadModel, KnowsNoSpeedUnderConstantCuttingSpeed) {
  const Read fanuc("S1000 M3\nG96 S200\nG1 X10 F100\nG97 S900\nX20\n");
  EXPECT_EQ(fanuc.of_line(fanuc.model({mill("")}), 3).second, 0);
  EXPECT_EQ(fanuc.of_line(fanuc.model({mill("")}), 5).second, 900);
  ReadOptions options;
  options.dialect = Dialect::sinumerik;
  const Read sinumerik("S1000 M3\nG96 S200\nG1 X10 F0.1\nG97 S900\nX20 F0.1\n", options);
  EXPECT_EQ(sinumerik.of_line(sinumerik.model({mill("")}), 3).second, 0);
  EXPECT_EQ(sinumerik.of_line(sinumerik.model({mill("")}), 5).second, 900);
}

TEST(LoadModel, ReadsToolAndSpeedOfEveryDialect) {
  ReadOptions heidenhain;
  heidenhain.dialect = Dialect::heidenhain;
  const Read plate(
      "0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S4000\n2 L X+0 Y+0 R0 FMAX M3\n3 L X+10 F500\n4 END PGM A MM\n",
      heidenhain);
  EXPECT_EQ(plate.of_line(plate.model({mill("5")}), 4), std::pair(0, 4000.0));
  ReadOptions sinumerik;
  sinumerik.dialect = Dialect::sinumerik;
  const Read named("T=\"MILL_10\" M6\nS5000 M3\nG1 X10 F500\nM30\n", sinumerik);
  EXPECT_EQ(named.of_line(named.model({mill("MILL_10")}), 3), std::pair(0, 5000.0));
}

TEST(LoadModel, RefusesWhatTheProgramDoesNotHave) {
  const Read read(two_tools);
  EXPECT_THAT(
      [&] { read.model({mill("3")}); },
      ThrowsMessage<InputError>(HasSubstr("operation for tool 3, which the program never changes to")));
  EXPECT_THAT(
      [&] {
        read.model({mill("", {{5, 50}})});
      },
      ThrowsMessage<InputError>(HasSubstr("lines 5-50, but the program has 11 lines")));
  EXPECT_THAT(
      [&] {
        read.model({mill("1"), mill("1")});
      },
      ThrowsMessage<InputError>(HasSubstr("apply to the same motions")));
  EXPECT_THAT([] { Read("G1 X10 F100\n").model({mill("1")}); },
              ThrowsMessage<InputError>(HasSubstr("changes to no tool; omit 'tool'")));
  Engagement wide = mill("1");
  wide.radial_depth = 11;
  EXPECT_THAT([&] { read.model({wide}); }, ThrowsMessage<InputError>(HasSubstr("ae_mm 11 is larger")));
  Engagement wood = mill("1");
  wood.material = "wood";
  EXPECT_THAT([&] { read.model({wood}); },
              ThrowsMessage<InputError>(HasSubstr("material 'wood' is not known")));
}

}  // namespace
}  // namespace feedscope
