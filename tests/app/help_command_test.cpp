#include <algorithm>
#include <regex>
#include <set>

#include "core/handbook/handbook.h"
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

std::set<std::string> options_in(const std::string& text, const char* before) {
  const std::regex option(std::string(before) + "(--[a-z][a-z-]+)");
  std::set<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), option); match != std::sregex_iterator();
       ++match) {
    found.insert((*match)[1].str());
  }
  return found;
}

/// An option that nobody described would be found by nobody; one that is gone would be tried in vain.
TEST_F(HelpCommand, TheHandbookHasTheOptionsThatThereAre) {
  std::set<std::string> options = options_in(run("--help").out, "\n  (?:-.,)?");
  for (const char* command : {"simulate", "explain", "compare", "check", "circular", "machines", "models",
                              "lessons", "trace", "identify", "help", "render", "report"}) {
    const Result help = run(std::string("help ") + command);
    ASSERT_EQ(help.code, 0) << command;
    options.merge(options_in(help.out, "\n  (?:-.,)?"));
  }
  ASSERT_GT(options.size(), 80U);
  for (const char* language : {"en", "fr"}) {
    std::set<std::string> described;
    const Handbook handbook(language);
    for (const HandbookPage& page : handbook.pages()) {
      described.merge(options_in(page.markdown, "(?:^|[^-\\w])"));
    }
    EXPECT_EQ(described, options) << language;
  }
}

/// Columns of the motion, corners and deviations, in the table of the handbook.
TEST_F(HelpCommand, TheHandbookHasTheColumnsThatAreWritten) {
  for (const char* language : {"en", "fr"}) {
    const std::string page = Handbook(language).find("command-line")->markdown;
    for (const char* table : {"--csv", "--blends", "--contour"}) {
      const Result written = run(std::string("simulate corner.nc ") + table + " -");
      ASSERT_EQ(written.code, 0) << written.err;
      const std::regex word("\\w+");
      const std::string header = written.out.substr(0, written.out.find('\n'));
      for (auto name = std::sregex_iterator(header.begin(), header.end(), word);
           name != std::sregex_iterator(); ++name) {
        EXPECT_TRUE(std::regex_search(page, std::regex("\\b" + name->str() + "\\b")))
            << table << ": " << name->str() << ", " << language;
      }
    }
  }
}

}  // namespace
}  // namespace feedscope::test
