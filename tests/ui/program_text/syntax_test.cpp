#include "ui/program_text/syntax.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "core/program/text/source_text.h"
#include "tests/support/folders.h"

namespace feedscope::ui {
namespace {

using testing::ElementsAre;
using testing::Pair;
using Kind = TokenKind;
using Pieces = std::vector<std::pair<std::string, Kind>>;

Pieces pieces(std::string_view line, Dialect dialect) {
  Syntax syntax(dialect);
  Pieces found;
  for (const Token& token : syntax.tokens_of(line)) {
    found.emplace_back(line.substr(token.from, token.length), token.kind);
  }
  return found;
}

TEST(Syntax, OfIsoWords) {
  EXPECT_THAT(
      pieces("N10 G01X-1.5 Y 2 F1000 M3 S8000 T1 (TOOL (A) B) Z3 ; end", Dialect::iso),
      ElementsAre(Pair("N10", Kind::label), Pair("G01", Kind::g_code), Pair("X", Kind::axis_x),
                  Pair("Y", Kind::axis_y), Pair("F1000", Kind::feed), Pair("M3", Kind::m_code),
                  Pair("S8000", Kind::feed), Pair("T1", Kind::tool), Pair("(TOOL (A) B)", Kind::comment),
                  Pair("Z", Kind::axis_z), Pair("; end", Kind::comment)));
  EXPECT_THAT(pieces("g2 x1 i4 j0", Dialect::iso),
              ElementsAre(Pair("g2", Kind::g_code), Pair("x", Kind::axis_x), Pair("i", Kind::argument),
                          Pair("j", Kind::argument)));
}

TEST(Syntax, OfMacros) {
  EXPECT_THAT(pieces("WHILE [#1 LT 5] DO1", Dialect::fanuc),
              ElementsAre(Pair("WHILE", Kind::keyword), Pair("#1", Kind::variable), Pair("LT", Kind::keyword),
                          Pair("DO", Kind::keyword)));
  EXPECT_THAT(pieces("o<hole> call [#<depth>]", Dialect::linuxcnc),
              ElementsAre(Pair("o<hole>", Kind::label), Pair("call", Kind::keyword),
                          Pair("#<depth>", Kind::variable)));
}

TEST(Syntax, OfBlocksThatMayBeSkipped) {
  EXPECT_THAT(pieces("/2 G1", Dialect::iso),
              ElementsAre(Pair("/2", Kind::block_delete), Pair("G1", Kind::g_code)));
  EXPECT_THAT(pieces("N5 /G1", Dialect::iso),
              ElementsAre(Pair("N5", Kind::label), Pair("/", Kind::block_delete), Pair("G1", Kind::g_code)));
  EXPECT_THAT(pieces("X[1/2]", Dialect::iso), ElementsAre(Pair("X", Kind::axis_x)));
}

TEST(Syntax, OfSinumerik) {
  EXPECT_THAT(
      pieces("N90 POCKETS(DEPTH+R1-5,8) ; four", Dialect::sinumerik),
      ElementsAre(Pair("N90", Kind::label), Pair("POCKETS", Kind::keyword), Pair("DEPTH", Kind::variable),
                  Pair("R1", Kind::variable), Pair("; four", Kind::comment)));
  EXPECT_THAT(pieces("IF R1<5 GOTOF LOOP", Dialect::sinumerik),
              ElementsAre(Pair("IF", Kind::keyword), Pair("R1", Kind::variable), Pair("GOTOF", Kind::keyword),
                          Pair("LOOP", Kind::keyword)));
  EXPECT_THAT(
      pieces("LOOP: X=SIN(DEPTH) T=\"MILL D8\"", Dialect::sinumerik),
      ElementsAre(Pair("LOOP:", Kind::label), Pair("X", Kind::axis_x), Pair("SIN", Kind::keyword),
                  Pair("DEPTH", Kind::variable), Pair("T", Kind::tool), Pair("\"MILL D8\"", Kind::literal)));
  EXPECT_THAT(
      pieces("REST=$AA_IM[X]", Dialect::sinumerik),
      ElementsAre(Pair("REST", Kind::variable), Pair("$AA_IM", Kind::variable), Pair("X", Kind::axis_x)));
}

TEST(Syntax, OfHeidenhain) {
  EXPECT_THAT(pieces("10 L X-20 IY+Q5 Z+2,5 R0 FMAX M3", Dialect::heidenhain),
              ElementsAre(Pair("10", Kind::label), Pair("L", Kind::keyword), Pair("X", Kind::axis_x),
                          Pair("IY", Kind::axis_y), Pair("Q5", Kind::variable), Pair("Z", Kind::axis_z),
                          Pair("R0", Kind::argument), Pair("FMAX", Kind::feed), Pair("M3", Kind::m_code)));
  EXPECT_THAT(pieces("6 * - Contour", Dialect::heidenhain),
              ElementsAre(Pair("6", Kind::label), Pair("* - Contour", Kind::comment)));
  EXPECT_THAT(pieces("26 CP IPA+1440 IZ-12 DR+ F500", Dialect::heidenhain),
              ElementsAre(Pair("26", Kind::label), Pair("CP", Kind::keyword), Pair("IPA", Kind::argument),
                          Pair("IZ", Kind::axis_z), Pair("DR", Kind::argument), Pair("F500", Kind::feed)));
  EXPECT_THAT(
      pieces("13 LBL \"PASS\"", Dialect::heidenhain),
      ElementsAre(Pair("13", Kind::label), Pair("LBL", Kind::keyword), Pair("\"PASS\"", Kind::literal)));
}

TEST(Syntax, OfHeidenhainIso) {
  EXPECT_THAT(pieces("N230 G02 X+Q2 IY+0 F AUTO *", Dialect::heidenhain_iso),
              ElementsAre(Pair("N230", Kind::label), Pair("G02", Kind::g_code), Pair("X", Kind::axis_x),
                          Pair("Q2", Kind::variable), Pair("IY", Kind::axis_y), Pair("F", Kind::feed),
                          Pair("AUTO", Kind::keyword)));
}

/// Pieces lie in the line, in order, and do not overlap.
void expect_sound(std::string_view line, Dialect dialect) {
  Syntax syntax(dialect);
  std::size_t end = 0;
  for (const Token& token : syntax.tokens_of(line)) {
    ASSERT_GE(token.from, end) << line;
    ASSERT_GT(token.length, 0U) << line;
    end = token.from + token.length;
    ASSERT_LE(end, line.size()) << line;
  }
}

TEST(Syntax, OfAnyTextIsSound) {
  constexpr std::string_view letters = "GMXYZNOQRFIAL#<>[]()/%*;\"$=+-.,:_ 0123\t\xC3\xBC";
  std::mt19937 random(2);
  std::uniform_int_distribution<std::size_t> pick(0, letters.size() - 1);
  for (int i = 0; i < 20000; ++i) {
    std::string line(static_cast<std::size_t>(i % 30), ' ');
    for (char& c : line) {
      c = letters[pick(random)];
    }
    for (const DialectInfo& dialect : all_dialects()) {
      expect_sound(line, dialect.dialect);
    }
  }
}

TEST(Syntax, OfTheSampleProgramsIsSound) {
  const std::filesystem::path folder = FEEDSCOPE_SOURCE_DIR "/resources/programs";
  std::size_t coloured = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const SourceText source = SourceText::from_file(entry.path());
    const Dialect dialect = recognise(source);
    Syntax syntax(dialect);
    for (std::uint32_t line = 1; line <= source.line_count(); ++line) {
      expect_sound(source.line(line), dialect);
      coloured += syntax.tokens_of(source.line(line)).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(coloured, 1000U);
}

}  // namespace
}  // namespace feedscope::ui
