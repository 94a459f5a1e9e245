#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/program/sinumerik/read_sinumerik.h"

namespace feedscope {
namespace {

using testing::ElementsAre;

struct ValueCase {
  const char* expression;
  double value;
};

void PrintTo(const ValueCase& c, std::ostream* out) {
  *out << c.expression;
}

class SinumerikValues : public testing::TestWithParam<ValueCase> {};

TEST_P(SinumerikValues, ExpressionHasItsValue) {
  const std::string text = std::string(
                               "DEF INT NN=7\nDEF REAL VALS[2,3]=(1,2,3,4,5,6)\nDEF STRING[8] TXT=\"UP\"\n"
                               "DEF BOOL YES=TRUE\nR1=2 R2=-3.5 R[3]=40\nG0 X=") +
                           GetParam().expression;
  EXPECT_NEAR(end_of(text).x(), GetParam().value, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, SinumerikValues,
    testing::Values(ValueCase{"1+2*3", 7}, ValueCase{"(1+2)*3", 9}, ValueCase{"-R2", 3.5},
                    ValueCase{"7 DIV 2", 3}, ValueCase{"7 MOD 4", 3}, ValueCase{"R1*R[1+2]", 80},
                    ValueCase{"NN/2", 3.5}, ValueCase{"SIN(30)", 0.5}, ValueCase{"COS(60)", 0.5},
                    ValueCase{"TAN(45)", 1}, ValueCase{"ASIN(0.5)", 30}, ValueCase{"ACOS(0)", 90},
                    ValueCase{"ATAN2(1,-1)", 135}, ValueCase{"SQRT(16)", 4}, ValueCase{"POT(3)", 9},
                    ValueCase{"ABS(R2)", 3.5}, ValueCase{"TRUNC(-2.7)", -2}, ValueCase{"ROUND(2.5)", 3},
                    ValueCase{"ROUNDUP(2.1)", 3}, ValueCase{"LN(EXP(2))", 2}, ValueCase{"MINVAL(3,R1)", 2},
                    ValueCase{"MAXVAL(3,R1)", 3}, ValueCase{"BOUND(0,10,12)", 10}, ValueCase{"'H1F'", 31},
                    ValueCase{"'B101'", 5}, ValueCase{"VALS[1,2]", 6}, ValueCase{"VALS[0,1]", 2},
                    ValueCase{"2EX3", 2000}, ValueCase{"$PI", 3.14159265358979}, ValueCase{"$P_EP[X]", 0},
                    ValueCase{"ISVAR(\"NN\")+ISVAR(\"MM\")", 1}));

INSTANTIATE_TEST_SUITE_P(
    Logic, SinumerikValues,
    testing::Values(ValueCase{"R1==2", 1}, ValueCase{"R1<>2", 0}, ValueCase{"R1<2", 0}, ValueCase{"R1<=2", 1},
                    ValueCase{"R1>1", 1}, ValueCase{"R1>=3", 0}, ValueCase{"(R1==2) AND (NN==7)", 1},
                    ValueCase{"(R1==1) OR (NN==7)", 1}, ValueCase{"(R1==2) XOR (NN==7)", 0},
                    ValueCase{"NOT (R1==2)", 0}, ValueCase{"6 B_AND 3", 2}, ValueCase{"6 B_OR 3", 7},
                    ValueCase{"6 B_XOR 3", 5}, ValueCase{"B_NOT 0", -1}, ValueCase{"0.1*3==0.3", 1},
                    ValueCase{"YES", 1}, ValueCase{"TXT==\"UP\"", 1}, ValueCase{"TXT<>\"UP\"", 0},
                    ValueCase{"\"L\"<<NN==\"L7\"", 1},
                    // Comparisons bind least: 1 == (1 AND 0).
                    ValueCase{"1==1 AND 0", 0}));

TEST(SinumerikVariables, IntegersRoundAndArraysTakeListsAndRepeats) {
  EXPECT_THAT(
      xs_of("DEF INT NN\nDEF REAL VALS[3],MORE[3]=REP(4)\nNN=2.5\nG0 X=NN\nVALS=SET(1,2,3)\nX=VALS[2]\n"
            "VALS[1]=REP(8)\nX=VALS[0] \nX=VALS[2]\nX=MORE[2]"),
      ElementsAre(3, 3, 1, 8, 4));
}

TEST(SinumerikVariables, NamesOfOneLetterAreTheProgramsOnceDefined) {
  EXPECT_THAT(
      xs_of("DEF INT I=2\nDEF REAL A[2,3]\nDEF STRING[4] S=\"UP\"\nA[0,0]=SET(1,2,3,4,5,6)\nG0 X=A[1,2]\n"
            "I=I+1\nX=I\nIF S==\"UP\" GOTOF UP_1\nX99\nUP_1: X8"),
      ElementsAre(6, 3, 8));
}

TEST(SinumerikFlow, IfElseAndNestedOnes) {
  const char* const text = "IF R1==1\nG0 X1\nELSE\nIF R1==2\nG0 X2\nENDIF\nG0 X3\nENDIF\nX4";
  EXPECT_THAT(xs_of(std::string("R1=1\n") + text), ElementsAre(1, 4));
  EXPECT_THAT(xs_of(std::string("R1=2\n") + text), ElementsAre(2, 3, 4));
  EXPECT_THAT(xs_of(std::string("R1=0\n") + text), ElementsAre(3, 4));
}

TEST(SinumerikFlow, Loops) {
  EXPECT_THAT(xs_of("G0\nFOR R1=1 TO 3\nX=R1\nENDFOR"), ElementsAre(1, 2, 3));
  EXPECT_THAT(xs_of("DEF INT COUNT\nG0 X9\nFOR COUNT=5 TO 4\nX=COUNT\nENDFOR"), ElementsAre(9));
  EXPECT_THAT(xs_of("G0\nR1=0\nWHILE R1<3\nR1=R1+1\nX=R1\nENDWHILE"), ElementsAre(1, 2, 3));
  EXPECT_THAT(xs_of("G0\nR1=0\nREPEAT\nR1=R1+1\nX=R1\nUNTIL R1>=2"), ElementsAre(1, 2));
  EXPECT_THAT(xs_of("G0\nR1=0\nLOOP\nR1=R1+1\nX=R1\nIF R1==3 GOTOF OUT_1\nENDLOOP\nOUT_1: X7"),
              ElementsAre(1, 2, 3, 7));
  EXPECT_THAT(xs_of("G0\nFOR R1=1 TO 2\nFOR R2=1 TO 2\nX=R1*10+R2\nENDFOR\nENDFOR"),
              ElementsAre(11, 12, 21, 22));
}

TEST(SinumerikFlow, JumpsByLabelNumberTextAndCase) {
  EXPECT_THAT(xs_of("G0 X1\nGOTOF HERE\nX2\nHERE: X3"), ElementsAre(1, 3));
  EXPECT_THAT(xs_of("G0 X1\nGOTO N040\nX2\nN40 X3"), ElementsAre(1, 3));
  EXPECT_THAT(xs_of("R1=0\nAGAIN: R1=R1+1\nG0 X=R1\nIF R1<3 GOTOB AGAIN"), ElementsAre(1, 2, 3));
  EXPECT_THAT(xs_of("R1=2\nG0 X1\nGOTOF \"LB\"<<R1\nLB1: X2\nLB2: X3"), ElementsAre(1, 3));
  EXPECT_THAT(xs_of("R1=2\nG0\nCASE R1 OF 1 GOTOF AA 2 GOTOF BB DEFAULT GOTOF CC\nAA: X1\nBB: X2\nCC: X3"),
              ElementsAre(2, 3));
  EXPECT_THAT(xs_of("R1=7\nG0\nCASE R1 OF 1 GOTOF AA 2 GOTOF BB DEFAULT GOTOF CC\nAA: X1\nBB: X2\nCC: X3"),
              ElementsAre(3));
  EXPECT_THAT(xs_of("G0 X1\nGOTOC NOWHERE\nX2"), ElementsAre(1, 2));
  EXPECT_THAT(xs_of("R1=1\nG0\nIF R1==0 GOTOF AA IF R1==1 GOTOF BB\nAA: X1\nBB: X2"), ElementsAre(2));
}

TEST(SinumerikFlow, PartsAreRepeated) {
  EXPECT_THAT(xs_of("G0 G91\nPART: X1\nX2\nREPEAT PART P=2\nX5"), ElementsAre(1, 3, 4, 6, 7, 9, 14));
  EXPECT_THAT(xs_of("G0 G91\nPART: X1\nX2\nPART_END:\nX9\nREPEAT PART PART_END"),
              ElementsAre(1, 3, 12, 13, 15));
  EXPECT_THAT(xs_of("G0 G91\nPART: X1\nX2\nREPEATB PART P3\nX9"), ElementsAre(1, 3, 4, 5, 6, 15));
  EXPECT_THAT(xs_of("G0 G91\nPART: X1\nENDLABEL:\nX2\nREPEAT PART P=1"), ElementsAre(1, 3, 4));
  EXPECT_THAT(xs_of("G0 G91 X1\nREPEAT PART ENDPART\nGOTOF DONE\nPART: X5\nENDPART: X6\nDONE: X10"),
              ElementsAre(1, 6, 12, 22));
}

TEST(SinumerikFlow, EndlessLoopEndsAtTheLimit) {
  const auto source = std::make_shared<const SourceText>("t.mpf", "G0 X1\nLOOP\nR1=R1+1\nENDLOOP");
  const ReadProgram program =
      read_program(source, nullptr, {.dialect = Dialect::sinumerik, .repeat_limit = 1000});
  EXPECT_THAT(program.diagnostics, testing::Contains(testing::Field(&Diagnostic::code, "run-limit")));
}

}  // namespace
}  // namespace feedscope
