#include "core/trace/guess_trace.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace feedscope {
namespace {

TraceGuess guess(const std::string& text) {
  // Tests run side by side.
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto file = std::filesystem::temp_directory_path() / ("feedscope_guess_trace_" + test + ".txt");
  std::ofstream(file) << text;
  const GuessedTrace guessed = guess_trace(file);
  std::filesystem::remove(file);
  EXPECT_EQ(guessed.problem.empty(), guessed.guess != TraceGuess::columns_wanted) << guessed.problem;
  return guessed.guess;
}

std::string rows(const std::string& row) {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += std::to_string(i) + row + "\n";
  }
  return text;
}

TEST(GuessTrace, KnowsTablesThatSayWhatTheyHold) {
  EXPECT_EQ(guess("time [s],x [mm],y [mm]\n" + rows(",1.5,2.5")), TraceGuess::readable);
  EXPECT_EQ(guess(rows(" 1.5 2.5 0.0")), TraceGuess::readable) << "halsampler";
}

TEST(GuessTrace, AsksWhereNothingSaysWhatTheColumnsAre) {
  EXPECT_EQ(guess("a;b;c\n" + rows(";1,5;2,5")), TraceGuess::columns_wanted);
  EXPECT_EQ(guess(rows(",1.5,2.5")), TraceGuess::columns_wanted);
}

TEST(GuessTrace, TakesNoProgramForATrace) {
  EXPECT_EQ(guess("G21 G90\nG1 X10 Y10 F1000\nX20\nM30\n"), TraceGuess::none);
  EXPECT_EQ(guess("0 BEGIN PGM P MM\n1 L X+10 Y+10 F1000\n2 L X+20\n3 END PGM P MM\n"), TraceGuess::none);
  EXPECT_EQ(guess("G65 P9001\n" + std::string("1 2\n3 4\n") + "M30\n"), TraceGuess::none);
  EXPECT_EQ(guess(""), TraceGuess::none);
  EXPECT_EQ(guess_trace("/no/such/file").guess, TraceGuess::none);
}

}  // namespace
}  // namespace feedscope
