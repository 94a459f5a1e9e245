#include "core/base/diagnostic.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

TEST(Diagnostic, PrintsPlaceSeverityMessageCodeAndHint) {
  const Diagnostic d{Severity::error,
                     3,
                     7,
                     "arc-radius",
                     Message::as_written("radius is off"),
                     Message::as_written("check I and J")};
  EXPECT_EQ(format(d, "part.nc"), "part.nc:3:7: error: radius is off [arc-radius] (check I and J)");
}

TEST(Diagnostic, LeavesOutPlaceAndHintThatAreNotKnown) {
  EXPECT_EQ(format({Severity::warning, 0, 0, "empty", Message::as_written("no blocks"), {}}, "part.nc"),
            "part.nc: warning: no blocks [empty]");
  EXPECT_EQ(format({Severity::info, 2, 0, "x", Message::as_written("y"), {}}, "part.nc"),
            "part.nc:2: info: y [x]");
}

TEST(Diagnostic, OnlyErrorsCountAsErrors) {
  EXPECT_FALSE(has_errors({{Severity::warning, 1, 1, "a", {}, {}}, {Severity::info, 1, 1, "a", {}, {}}}));
  EXPECT_TRUE(has_errors({{Severity::info, 1, 1, "a", {}, {}}, {Severity::error, 1, 1, "a", {}, {}}}));
}

std::string printed(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const RepeatedDiagnostic& repeated : without_repeats(diagnostics)) {
    text += std::to_string(repeated.first->line) + " " + repeated.first->message.english() + "|" +
            repeats_text(repeated).english() + "\n";
  }
  return text;
}

Diagnostic at(std::uint32_t line, const std::string& code, const std::string& message) {
  Diagnostic diagnostic;
  diagnostic.line = line;
  diagnostic.code = code;
  diagnostic.message = Message::as_written(message);
  return diagnostic;
}

Diagnostic closing(std::uint32_t line, const std::string& code, std::uint64_t count, std::uint32_t last) {
  Diagnostic diagnostic = at(line, code, "more like it");
  diagnostic.count = count;
  diagnostic.last_line = last;
  return diagnostic;
}

TEST(WithoutRepeats, SaysOnceWhatIsTheSameWithItsLines) {
  EXPECT_EQ(printed({at(1, "a", "x"), at(2, "a", "x"), at(3, "b", "x"), at(5, "a", "x"), at(9, "a", "y")}),
            "1 x|also in lines 2 and 5\n3 x|\n9 y|\n");
  EXPECT_EQ(printed({at(1, "a", "x"), at(1, "a", "x"), at(4, "a", "x")}), "1 x|also in line 4\n");
  Diagnostic called = at(2, "a", "x");
  called.file = "sub.nc";
  EXPECT_EQ(printed({at(1, "a", "x"), called}), "1 x|\n2 x|\n") << "another file";
}

TEST(WithoutRepeats, TakesTheCountOfTheRestToTheOnlyMessageOfItsKind) {
  EXPECT_EQ(printed({at(1, "a", "x"), at(2, "a", "x"), closing(3, "a", 40, 90)}),
            "1 x|also in line 2; 40 more up to line 90\n");
  EXPECT_EQ(printed({at(1, "a", "x"), closing(3, "a", 1, 3)}), "1 x|1 more up to line 3\n");
  EXPECT_EQ(printed({at(1, "a", "x"), at(2, "a", "y"), closing(3, "a", 40, 90)}),
            "1 x|\n2 y|\n3 more like it|\n")
      << "of which of both is not known";
  Diagnostic other = at(2, "a", "y");
  other.detail = 1;
  Diagnostic rest = closing(3, "a", 40, 90);
  EXPECT_EQ(printed({other, at(3, "a", "x"), rest}), "2 y|\n3 x|40 more up to line 90\n");
  rest.detail = 1;
  EXPECT_EQ(printed({at(1, "a", "x"), other, rest}), "1 x|\n2 y|40 more up to line 90\n");
}

TEST(WithoutRepeats, ListsTenFurtherLinesAndCountsTheOthers) {
  std::vector<Diagnostic> all;
  for (std::uint32_t line = 1; line <= 40000; ++line) {
    all.push_back(at(line, "a", "x"));
  }
  EXPECT_EQ(printed(all),
            "1 x|also in lines 2, 3, 4, 5, 6, 7, 8, 9, 10 and 11; 39989 more up to line 40000\n");
  all.push_back(closing(40001, "a", 11, 40011));
  EXPECT_EQ(printed(all),
            "1 x|also in lines 2, 3, 4, 5, 6, 7, 8, 9, 10 and 11; 40000 more up to line 40011\n");
}

TEST(WithoutRepeats, LosesNoPlace) {
  const std::vector<Diagnostic> all{at(1, "a", "x"), at(2, "a", "x"), at(2, "b", "z"),
                                    closing(3, "a", 40, 90)};
  EXPECT_EQ(count_of(all, Severity::error), 43U);
  std::uint64_t places = 0;
  for (const RepeatedDiagnostic& repeated : without_repeats(all)) {
    places += 1 + repeated.further_lines.size() + repeated.unlisted;
  }
  EXPECT_EQ(places, 43U);
}

}  // namespace
}  // namespace feedscope
