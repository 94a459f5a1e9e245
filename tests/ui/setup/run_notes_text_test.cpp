#include "ui/setup/run_notes_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/locale_in_force.h"

namespace feedscope::ui {
namespace {

/// A circle of R 50 mm in chords of 0.5 mm: a chord error of 0.63 um.
Run run_of(const std::string& tolerance) {
  std::string text = "G21 G90\nG0 X50 Y0\nG1 F2000\n";
  for (int i = 1; i <= 400; ++i) {
    text += fmt::format("X{:.5f} Y{:.5f}\n", 50 * std::cos(0.01 * i), 50 * std::sin(0.01 * i));
  }
  const LoadedProgram program = load_program(std::make_shared<const SourceText>("circle.nc", text + "M30\n"));
  SetupRequest request;
  request.model = "essid";
  request.assignments = {"contour_tolerance_mm=" + tolerance};
  return simulate_run(program, make_setup(request));
}

TEST(RunNoteTexts, SayWhatTheToleranceIsOfTheChordErrorWhereItIsUnadvised) {
  const test::LocaleInForce locale(QLocale::c());
  EXPECT_THAT(run_note_texts(run_of("0.01")).join('\n').toStdString(),
              testing::ContainsRegex("contour tolerance of 0.01.* mm is 1[56][0-9]{2} % of the estimated "
                                     "chord error of the short lines .0.0006.* mm.; Heidenhain advises"));
  EXPECT_THAT(run_note_texts(run_of("0.001")).join('\n').toStdString(),
              testing::Not(testing::HasSubstr("chord error")));
}

TEST(RunNoteTexts, NameAFeedThatTheMachineReachesInNoDirection) {
  const test::LocaleInForce locale(QLocale::c());
  const auto notes = [](const std::string& feed) {
    const LoadedProgram program = load_program(
        std::make_shared<const SourceText>("line.nc", "G21 G90\nG1 X10 F1000\nX20 F" + feed + "\nM30\n"));
    SetupRequest request;
    request.machine = "huron-kx10";
    return run_note_texts(simulate_run(program, make_setup(request))).join('\n').toStdString();
  };
  EXPECT_THAT(notes("9991300"),
              testing::ContainsRegex("Line 3 asks for a feed of 9,?991,?300.* mm/min; all axes of "
                                     "this machine together reach 1[0-9],?[0-9]{3}.* mm/min"));
  EXPECT_THAT(notes("10000"), testing::Not(testing::HasSubstr("asks for a feed")));
}

}  // namespace
}  // namespace feedscope::ui
