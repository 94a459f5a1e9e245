#include "core/program/text/diagnostic_log.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

DiagnosticLog::Text text() {
  return {Message::as_written("message"), Message::as_written("hint")};
}

TEST(DiagnosticLog, KeepsTenOfAKindAndCountsTheRest) {
  DiagnosticLog log;
  int made = 0;
  for (std::uint32_t line = 1; line <= 1000; ++line) {
    log.add(Severity::warning, "label", 0, {line, 3}, [&] {
      ++made;
      return text();
    });
  }
  const std::vector<Diagnostic> all = log.take();
  ASSERT_EQ(all.size(), 11U);
  EXPECT_EQ(made, 10) << "text is made for what is kept only";
  EXPECT_EQ(format(all[9], "f"), "f:10:3: warning: message [label] (hint)");
  EXPECT_EQ(format(all[10], "f"), "f:11: warning: 990 more of this kind up to line 1000 [label]");
}

TEST(DiagnosticLog, DetailMakesAKindOfItsOwn) {
  DiagnosticLog log;
  for (int detail = 0; detail < 20; ++detail) {
    log.add(Severity::error, "label", detail, {1, 1}, text);
  }
  EXPECT_EQ(log.take().size(), 20U);
}

TEST(DiagnosticLog, KeepsOneInfoOfAKind) {
  DiagnosticLog log;
  for (std::uint32_t line = 1; line <= 5; ++line) {
    log.add(Severity::info, "label", 0, {line, 1}, text);
  }
  const std::vector<Diagnostic> all = log.take();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].severity, Severity::info);
}

TEST(DiagnosticLog, SortsByPlaceAndIsEmptyAfterwards) {
  DiagnosticLog log;
  log.add(Severity::error, "pole", 0, {2, 5}, text);
  log.add(Severity::error, "label", 0, {2, 1}, text);
  log.add(Severity::error, "corner", 0, {1, 9}, text);
  const std::vector<Diagnostic> all = log.take();
  EXPECT_EQ(all[0].code, "corner");
  EXPECT_EQ(all[1].code, "label");
  EXPECT_EQ(all[2].code, "pole");
  EXPECT_TRUE(log.take().empty());
}

}  // namespace
}  // namespace feedscope
