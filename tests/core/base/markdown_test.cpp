#include "core/base/markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace feedscope {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Markdown, TablesHaveHeadingsAndMarksInTheirCells) {
  const std::string html = markdown_as_html("Before\n\n| a | `b` |\n|---|---|\n| **c** | |\n\nAfter\n");
  EXPECT_THAT(html, HasSubstr("<p>Before</p>\n<table"));
  EXPECT_THAT(html,
              HasSubstr("<tr><th align=\"left\"> a </th><th align=\"left\"> <code>b</code> </th></tr>\n"
                        "<tr><td align=\"left\"> <strong>c</strong> </td><td align=\"left\"> </td></tr>\n"
                        "</table>\n<p>After</p>"));
}

TEST(Markdown, BarsWithoutARuleAreText) {
  EXPECT_EQ(markdown_as_html("| a | b |\n| c | d |\n"), "<p>| a | b |\n| c | d |</p>\n");
  EXPECT_EQ(markdown_as_html("|x| is the size of x\n"), "<p>|x| is the size of x</p>\n");
  EXPECT_THAT(markdown_as_html("    | a |\n    |---|\n"), Not(HasSubstr("<table")));
}

TEST(Markdown, IndicesOfSymbolsAreSetLow) {
  EXPECT_EQ(markdown_as_html("**K_v times** T_v / (a_e)."),
            "<p><strong>K<sub>v</sub> times</strong> T<sub>v</sub> / (a<sub>e</sub>).</p>\n");
  EXPECT_EQ(markdown_as_html("`K_v`, max_x, x_max, _K_v_"),
            "<p><code>K_v</code>, max_x, x_max, <em>K<sub>v</sub></em></p>\n");
}

}  // namespace
}  // namespace feedscope
