#include "core/program/text/diagnostic_log.h"

#include <gtest/gtest.h>

namespace feedscope {
namespace {

DiagnosticLog::Text text() {
  return {"message", "hint"};
}

TEST(DiagnosticLog, KeepsTenOfAKindAndCountsTheRest) {
  DiagnosticLog log;
  int made = 0;
  for (std::uint32_t line = 1; line <= 1000; ++line) {
    log.add(Severity::warning, "code", 0, {line, 3}, [&] {
      ++made;
      return text();
    });
  }
  const std::vector<Diagnostic> all = log.take();
  ASSERT_EQ(all.size(), 11U);
  EXPECT_EQ(made, 10) << "text is made for what is kept only";
  EXPECT_EQ(format(all[9], "f"), "f:10:3: warning: message [code] (hint)");
  EXPECT_EQ(format(all[10], "f"), "f:11: warning: 990 more like it from here up to line 1000 [code]");
}

TEST(DiagnosticLog, DetailMakesAKindOfItsOwn) {
  DiagnosticLog log;
  for (int detail = 0; detail < 20; ++detail) {
    log.add(Severity::error, "code", detail, {1, 1}, text);
  }
  EXPECT_EQ(log.take().size(), 20U);
}

TEST(DiagnosticLog, KeepsOneInfoOfAKind) {
  DiagnosticLog log;
  for (std::uint32_t line = 1; line <= 5; ++line) {
    log.add(Severity::info, "code", 0, {line, 1}, text);
  }
  const std::vector<Diagnostic> all = log.take();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].severity, Severity::info);
}

TEST(DiagnosticLog, SortsByPlaceAndIsEmptyAfterwards) {
  DiagnosticLog log;
  log.add(Severity::error, "a", 0, {2, 5}, text);
  log.add(Severity::error, "b", 0, {2, 1}, text);
  log.add(Severity::error, "c", 0, {1, 9}, text);
  const std::vector<Diagnostic> all = log.take();
  EXPECT_EQ(all[0].code, "c");
  EXPECT_EQ(all[1].code, "b");
  EXPECT_EQ(all[2].code, "a");
  EXPECT_TRUE(log.take().empty());
}

}  // namespace
}  // namespace feedscope
