#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/program/program.h"

namespace feedscope {
namespace {

ReadProgram read(const std::string& name, const std::string& text, const ReadOptions& options = {}) {
  return read_program(std::make_shared<const SourceText>(name, text), nullptr, options);
}

bool is_foreign(const ReadProgram& program) {
  return !program.diagnostics.empty() && program.diagnostics.front().code == "unsupported-control";
}

constexpr const char* okuma = "N1 G15 H1\nG0 X10 Y0\nG56 H2 Z50\nVC1=5\nCALL O100\nG1 X20 F100\nM2\n";

TEST(ForeignLanguage, OkumaIsRecognisedAndNotTakenForAnother) {
  const ReadProgram program = read("part.nc", okuma);
  EXPECT_EQ(program.dialect, Dialect::iso);
  ASSERT_TRUE(is_foreign(program));
  EXPECT_EQ(
      format(program.diagnostics.front(), "f"),
      "f:1: error: this is a program for Okuma OSP, which is not supported [unsupported-control] (it is "
      "interpreted "
      "as ISO and the path shown may be wrong: G15 H selects a work offset there, G56 H a tool length, VC1 "
      "is a variable and CALL a subprogram; give --dialect to interpret it as that dialect)");
  for (const char* name : {"PART.MIN", "part.min", "SUB.SSB"}) {
    EXPECT_TRUE(is_foreign(read(name, "G0 X1\nG1 X2 F100\n"))) << name;
  }
  EXPECT_FALSE(is_foreign(read("part.nc", okuma, {.dialect = Dialect::fanuc}))) << "as asked for";
}

TEST(ForeignLanguage, WordsThatOthersHaveTooAreNoSign) {
  for (const char* text : {"G15\nG0 X1 H1\n", "G56\nG43 H2 Z5\n", "G90 G56 G43 H1 Z5\nG15 G80\n",
                           "O<call> call\n", "R1=5\nG0 X=R1\n", "(G15 H1 G56 H2 VC1=5)\nG0 X1\n",
                           "CALL LBL 1\nL X+1 FMAX\n", "#1=5\nG16\nG0 X1 Y30\nG15\n"}) {
    EXPECT_FALSE(is_foreign(read("part.nc", text))) << text;
  }
}

}  // namespace
}  // namespace feedscope
