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

}  // namespace
}  // namespace feedscope::ui
