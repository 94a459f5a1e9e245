#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/program/program.h"
#include "tests/core/program/mutated_text.h"
#include "tests/core/program/read_text.h"
#include "tests/support/program_checks.h"
#include "tests/support/random_cases.h"

namespace feedscope {
namespace {

/// Whatever the text, what comes out can be worked with.
void expect_sane(const std::string& text) {
  ASSERT_EQ(insane_part(read_text(text, {.dialect = Dialect::sinumerik, .repeat_limit = 300})), "") << text;
}

TEST(SinumerikGarbage, RandomWordsAreReadWithoutHarm) {
  constexpr std::string_view pieces[] = {"G0",
                                         "G1",
                                         "G2",
                                         "G3",
                                         "CIP",
                                         "CT",
                                         "BSPLINE",
                                         "ASPLINE",
                                         "CSPLINE",
                                         "POLY",
                                         "X",
                                         "Y",
                                         "Z",
                                         "I",
                                         "CR=",
                                         "AR=",
                                         "TURN=",
                                         "I1=",
                                         "AP=",
                                         "RP=",
                                         "PW=",
                                         "PL=",
                                         "SD=",
                                         "PO[X]=",
                                         "AC(",
                                         "IC(",
                                         "R1",
                                         "R[",
                                         "=",
                                         "(",
                                         ")",
                                         "[",
                                         "]",
                                         ",",
                                         "+",
                                         "-",
                                         "*",
                                         "/",
                                         "<<",
                                         "==",
                                         "<",
                                         "AND",
                                         "NOT",
                                         "SIN(",
                                         "DEFINE AB AS",
                                         "AB",
                                         "$P_PFRAME=",
                                         "$P_UIFR[1",
                                         "CTRANS(X,",
                                         "CROT(Z,",
                                         ":",
                                         "POS[Z]=",
                                         "FA[Z]=",
                                         "DEF FRAME FF",
                                         "FF=",
                                         "SQRT(",
                                         "1",
                                         "2",
                                         "0.5",
                                         "1EX9",
                                         "1e9",
                                         "IF",
                                         "ELSE",
                                         "ENDIF",
                                         "FOR",
                                         "TO",
                                         "ENDFOR",
                                         "WHILE",
                                         "ENDWHILE",
                                         "LOOP",
                                         "ENDLOOP",
                                         "REPEAT",
                                         "UNTIL",
                                         "REPEATB",
                                         "CASE",
                                         "OF",
                                         "GOTOF",
                                         "GOTOB",
                                         "AA",
                                         "AA:",
                                         "BB:",
                                         "N10",
                                         "DEF",
                                         "REAL",
                                         "STRING[8]",
                                         "PROC",
                                         "SUB1",
                                         "L10",
                                         "P3",
                                         "MCALL",
                                         "RET",
                                         "TRANS",
                                         "AROT",
                                         "ASCALE",
                                         "MIRROR",
                                         "G58",
                                         "SUPA",
                                         "G110",
                                         "G41",
                                         "G40",
                                         "D1",
                                         "T3",
                                         "$TC_DP6[3,1]=2",
                                         "CYCLE83(10,0,2,-20,,-8,,2,0,0,1,0)",
                                         "CYCLE832(0.1,1)",
                                         "HOLES2(0,0,5,0,0,4)",
                                         "CYCLE800(0,\"\",0,57,1,2,3,4,5,6)",
                                         "\"AA\"",
                                         "\"",
                                         "%_N_SUB1_SPF",
                                         "M17",
                                         "M30",
                                         ";",
                                         "\n",
                                         "\n",
                                         "\n",
                                         "\n",
                                         "\n",
                                         "\n",
                                         "\n",
                                         " ",
                                         " ",
                                         " ",
                                         " ",
                                         " ",
                                         "F100",
                                         "S500",
                                         "G4",
                                         "G33",
                                         "G91",
                                         "G18",
                                         "G642",
                                         "$P_EP[X]",
                                         "RND=",
                                         "RNDM=1",
                                         "CHF=",
                                         "CHR=2",
                                         "FRC=",
                                         "DIAMON"};
  std::mt19937 random(1);
  for (int round = 0; round < test::random_cases(30000); ++round) {
    std::string text;
    for (std::size_t i = random() % 60; i > 0; --i) {
      text += pieces[random() % std::size(pieces)];
      text += random() % 3 == 0 ? " " : "";
    }
    expect_sane(text);
    if (HasFatalFailure()) {
      FAIL() << "round " << round;
    }
  }
}

TEST(SinumerikGarbage, MutatedProgramsAreReadWithoutHarm) {
  const std::string sample =
      "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR\nDEF REAL LEN=5, VALS[3]=(1,2,3)\nDEF INT II\nG17 G90 G710 F500 "
      "S100\n"
      "TRANS X10\nAROT Z=30*R1\nG0 X1.5 Y-2 Z5\nG1 Z-1\nX9 RND=1\nY3 CHF=.5 RNDM=.2\nG2 X3 CR=4\nG3 X=IC(2) "
      "Y0 I1 J=AC(2)\nCIP X5 Y5 I1=3 "
      "J1=1\n"
      "FOR II=1 TO 3\nX=LEN*II Y=VALS[II-1]\nIF II==2 GOTOF NEXT\nG3 X10 AR=100\nNEXT:\nENDFOR\nR1=R1+1\n"
      "SUB1(LEN,\"A\") P2\nBSPLINE X1 Y1 PW=2\nX5 Y3\nX7 Y1\nCSPLINE X8 Y2\nX9 Y9\nPOLY PO[X]=(5,1,2) PL=2\n"
      "MCALL CYCLE83(10,0,2,-20,,-8,,2,0,0,1,0)\nG0 X1\nHOLES1(0,0,30,5,10,3)\nMCALL\nREPEAT NEXT P=2\n"
      "CYCLE832(0.02,1,1)\nDEFINE AWAY AS G0 Z50\nAWAY X3\n$P_UIFR[1]=CTRANS(X,5):CROT(Z,30)\nG54 G91 X1\n"
      "$P_PFRAME=$P_PFRAME:CSCALE(X,2)\nDEF FRAME FF=CMIRROR(X)\nFF[X,TR]=3\n$P_PFRAME[X,TR]=4\nFA[Z]=300\n"
      "POS[Z]=IC(2)\nG111 X1 Y2\nAP=30 RP=4\nAP=IC(9)\nM30\n%_N_SUB1_SPF\nPROC SUB1(VAR REAL AA,STRING[4] "
      "BB) SAVE\nAA=AA+1\nG91 "
      "X1\nM17\n";
  std::mt19937 random(3);
  for (int round = 0; round < test::random_cases(15000); ++round) {
    expect_sane(mutated(sample, random));
    if (HasFatalFailure()) {
      FAIL() << "round " << round;
    }
  }
}

TEST(SinumerikGarbage, BracketsWithoutEndAreReadWithoutHarm) {
  for (const char* const begin : {"G0 X=", "GOTOF ", "IF ", "CALL ", "MSG", "R[", "SUB1("}) {
    for (const char c : {'(', '[', '"', '-'}) {
      expect_sane("G0 X1\n" + std::string(begin) + std::string(100000, c));
    }
  }
}

}  // namespace
}  // namespace feedscope
