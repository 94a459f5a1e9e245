#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/program/program.h"

namespace feedscope {
namespace {

/// The contour, a line along X at Y0 from its entry on, is on the left of the tool.
struct Language {
  Dialect dialect;
  std::string program;     ///< asks for the radius of `tool`
  std::string tool;        ///< as people give it
  std::string programmed;  ///< a line that sets it to 2 mm
};

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {Dialect::fanuc, "G21 G17\nG42 D07 G1 X10 Y0 F100\nX20\nX30\n", "7", "G10 L12 P7 R2.\n"},
      {Dialect::linuxcnc, "G21 G17\nT7 M6\nG42 G1 X10 Y0 F100\nX20\nX30\n", "7", "G10 L1 P7 R2\n"},
      {Dialect::sinumerik, "G17 T4 D2\nG42 G1 X10 Y0 F100\nX20\nX30\n", "4,2", "$TC_DP6[4,2]=2\n"},
      {Dialect::heidenhain, "TOOL CALL \"Mill 8\" Z S1000\nL X+10 Y+0 RR F100\nL X+20\nL X+30\n", "mill 8",
       "TOOL DEF \"Mill 8\" R2\n"},
  };
  return all;
}

class CutterOf : public testing::TestWithParam<Language> {
 protected:
  void SetUp() override {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = std::filesystem::path(testing::TempDir()) / ("cutters_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  ReadProgram read(const std::string& before, ReadOptions options = {}) {
    options.dialect = GetParam().dialect;
    const std::filesystem::path file = write("part.nc", before + GetParam().program);
    return read_program(std::make_shared<const SourceText>(SourceText::from_file(file)), nullptr, options);
  }
  static const Diagnostic* find(const ReadProgram& program, std::string_view code) {
    for (const Diagnostic& diagnostic : program.diagnostics) {
      if (diagnostic.code == code) {
        return &diagnostic;
      }
    }
    return nullptr;
  }
  /// How far beside the contour the tool ends up.
  static double beside(const ReadProgram& program) { return -program.motions.back().target.y(); }

  std::filesystem::path folder_;
};

TEST_P(CutterOf, NobodyKnowsIsAnErrorThatSaysHowToGiveIt) {
  const ReadProgram program = read("");
  ASSERT_NE(find(program, "tool-radius"), nullptr);
  EXPECT_NE(find(program, "tool-radius")
                ->hint.english()
                .find("--tool " + CutterRadii::key(GetParam().tool) + "=RADIUS"),
            std::string::npos)
      << find(program, "tool-radius")->hint.english();
  EXPECT_EQ(beside(program), 0);
  ASSERT_EQ(program.cutters.size(), 1U);
  EXPECT_EQ(program.cutters[0].source, CutterSource::unknown);
  EXPECT_EQ(program.cutters[0].tool, CutterRadii::key(GetParam().tool));
}

TEST_P(CutterOf, IsGivenBesideTheProgram) {
  ReadOptions options;
  options.radii.set(GetParam().tool, 4);
  const ReadProgram program = read("", options);
  EXPECT_EQ(find(program, "tool-radius"), nullptr);
  EXPECT_NEAR(beside(program), 4, 1e-12);
  ASSERT_EQ(program.cutters.size(), 1U);
  EXPECT_EQ(program.cutters[0].source, CutterSource::asked);
  EXPECT_EQ(program.cutters[0].radius, 4);
}

TEST_P(CutterOf, IsFoundInATableBesideTheProgram) {
  write("TOOLS.CSV", "nr;radius\n" + GetParam().tool + ";3,5\n");
  const ReadProgram program = read("");
  EXPECT_NEAR(beside(program), 3.5, 1e-12);
  ASSERT_NE(find(program, "tool-table"), nullptr);
  EXPECT_EQ(find(program, "tool-table")->severity, Severity::info);
  EXPECT_EQ(program.cutters.at(0).source, CutterSource::table);
}

TEST_P(CutterOf, IsFoundInATableOfAnyName) {
  ReadOptions options;
  options.tool_table = write("mine.txt", "nr;diameter\n" + GetParam().tool + ";1\n");
  options.table_unit = 25.4;
  EXPECT_NEAR(beside(read("", options)), 12.7, 1e-12);
  options.tool_table = folder_ / "none.txt";
  EXPECT_THROW(read("", options), InputError);
}

TEST_P(CutterOf, AFaultyTableBesideTheProgramIsLeftAside) {
  write("tools.csv", "nr;radius\n" + GetParam().tool + ";wide\n");
  const ReadProgram program = read("");
  ASSERT_NE(find(program, "tool-table"), nullptr);
  EXPECT_EQ(find(program, "tool-table")->severity, Severity::warning);
  EXPECT_NE(find(program, "tool-radius"), nullptr);
}

TEST_P(CutterOf, OfTheProgramComesBeforeTheTableAndBehindWhatIsGiven) {
  write("tools.csv", "nr;radius\n" + GetParam().tool + ";3\n");
  EXPECT_NEAR(beside(read(GetParam().programmed)), 2, 1e-12);
  ReadOptions options;
  options.radii.set(GetParam().tool, 4);
  EXPECT_NEAR(beside(read(GetParam().programmed, options)), 4, 1e-12);
}

TEST_P(CutterOf, IsZeroWhereTheCamSystemHasCompensated) {
  write("tools.csv", "nr;radius\n" + GetParam().tool + ";3\n");
  ReadOptions options;
  options.wear_only = true;
  for (const std::string& before : {std::string(), GetParam().programmed}) {
    const ReadProgram program = read(before, options);
    EXPECT_FALSE(has_errors(program.diagnostics));
    EXPECT_EQ(beside(program), 0);
    EXPECT_EQ(program.cutters.at(0).source, CutterSource::asked);
  }
  options.radii.set(GetParam().tool, 0.02);
  EXPECT_NEAR(beside(read("", options)), 0.02, 1e-12) << "wear that is given";
}

INSTANTIATE_TEST_SUITE_P(Dialects, CutterOf, testing::ValuesIn(languages()),
                         [](const auto& test) { return std::string(info_of(test.param.dialect).id); });

TEST(Cutters, SinumeriksToolsMayHaveNames) {
  ReadOptions options{.dialect = Dialect::sinumerik};
  options.radii.set("mill_8,2", 4);
  const ReadProgram program = read_program(
      std::make_shared<const SourceText>("part.mpf", "T=\"MILL_8\" D2\nG42 G1 X10 Y0 F100\nX20\nX30\n"),
      nullptr, options);
  EXPECT_NEAR(program.motions.back().target.y(), -4, 1e-12);
  EXPECT_EQ(program.cutters.at(0).tool, "MILL_8,2");
  EXPECT_EQ(program.tools.at(0).name, "MILL_8");
}

TEST(CutterRadii, OneToolHasOneKey) {
  EXPECT_EQ(CutterRadii::key(" 007 "), "7");
  EXPECT_EQ(CutterRadii::key("0"), "0");
  EXPECT_EQ(CutterRadii::key("\"Mill 10\""), "MILL 10");
  EXPECT_EQ(CutterRadii::key("\"Mill 10\",1"), "MILL 10");
  EXPECT_EQ(CutterRadii::key("3,2"), "3,2");
  EXPECT_EQ(CutterRadii::key("0x1"), "0X1");
  for (const char* name : {"7,1,1", "\"Mill,1\"", "\" 007,1\" ,1", "7,2,1"}) {
    const std::string key = CutterRadii::key(name);
    EXPECT_EQ(CutterRadii::key(key), key) << name;
  }
}

TEST(CutterRadii, WhatHasNoNameIsNoTool) {
  CutterRadii radii;
  for (const char* name : {"", " \"\" ", ",1", ",2", "\",2\""}) {
    radii.set(name, 5);
    EXPECT_TRUE(radii.empty()) << name;
  }
}

}  // namespace
}  // namespace feedscope
