#include "ui/paper/html_table.h"
#include "ui/language/core_texts.h"

#include <gtest/gtest.h>

#include "ui/language/significant.h"
#include "ui/report/report_numbers.h"

namespace feedscope::ui {
namespace {

TEST(HtmlTable, TextIsEscapedAndLongWordsMayBeBroken) {
  EXPECT_EQ(html_text(QStringLiteral("a < b & \"c\"")), "a &lt; b &amp; &quot;c&quot;");
  EXPECT_EQ(html_text(QStringLiteral("short/path.nc")), "short/path.nc");
  const QString path = html_text(QStringLiteral("/a/very/long/folder_with_a_name/part.nc"));
  EXPECT_TRUE(path.contains("<wbr>"));
  EXPECT_EQ(QString(path).remove("<wbr>"), "/a/very/long/folder_with_a_name/part.nc");
  const QString word = html_text(QString(100, 'x'));
  EXPECT_GE(word.count("<wbr>"), 5);
  EXPECT_FALSE(word.endsWith("<wbr>"));
}

TEST(HtmlTable, HasHeadsRowsAndSides) {
  HtmlTable table("lr", {70, 0});
  EXPECT_TRUE(table.empty());
  table.add_group_head({{"both", 2}});
  table.add_head({"a", "b"});
  table.add({"1"});
  const QString html = table.html();
  EXPECT_TRUE(html.contains("<th align=\"center\" colspan=\"2\">both</th>"));
  EXPECT_TRUE(html.contains("<th align=\"left\" width=\"70%\">a</th><th align=\"right\">b</th>"));
  EXPECT_TRUE(html.contains("<td align=\"left\" width=\"70%\">1</td><td align=\"right\"></td>"));
  EXPECT_FALSE(table.empty());
}

TEST(ReportNumbers, ReadAsPeopleWriteThem) {
  EXPECT_EQ(fixed(1.26, 1), "1.3");
  EXPECT_EQ(fixed(-0.01, 1), "0.0");
  EXPECT_EQ(fixed(-0.06, 1), "-0.1");
  EXPECT_EQ(significant_number(0.1, 8), "0.1");
  EXPECT_EQ(significant_number(1234.5678, 3), "1235");
  EXPECT_EQ(significant_number(0.00123456, 3), "0.00123");
  EXPECT_EQ(significant_number(0, 3), "0");
  EXPECT_EQ(significant_number(1e-9, 3), "1e-09");
  EXPECT_EQ(significant_number(2e12, 3), "2e+12");
  EXPECT_EQ(unit_text("m/s3"), "m/s³");
}

}  // namespace
}  // namespace feedscope::ui
