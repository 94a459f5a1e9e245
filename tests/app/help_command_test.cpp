#include "tests/app/command_line.h"

namespace feedscope::test {
namespace {

using testing::HasSubstr;

class HelpCommand : public CommandLine {};

TEST_F(HelpCommand, NamesEveryCommand) {
  const Result result = run("help");
  EXPECT_EQ(result.code, 0);
  for (const char* command : {"simulate", "compare", "check", "machines", "models", "lessons", "help"}) {
    EXPECT_THAT(result.out, HasSubstr(command));
  }
}

TEST_F(HelpCommand, ExplainsOneCommandAsItsOwnHelpDoes) {
  const Result result = run("help simulate");
  EXPECT_THAT(result.out, HasSubstr("Usage: feedscope simulate"));
  EXPECT_THAT(result.out, HasSubstr("--csv"));
  expect_wrong_use("help simulat", "did you mean 'simulate'?");
}

TEST_F(HelpCommand, WritesTheHandbook) {
  EXPECT_THAT(run("help --html pages --language fr").out, HasSubstr("index.html"));
  EXPECT_TRUE(fs::exists(folder_ / "pages" / "trust.html"));
  EXPECT_THAT(run("help --html /dev/null/pages").err, HasSubstr("/dev/null/pages/index.html"));
  expect_wrong_use("help --language fr", "--html");
  expect_wrong_use("help --html pages --language xx", "xx");
}

}  // namespace
}  // namespace feedscope::test
