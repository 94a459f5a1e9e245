#include "ui/fields/whole_number_box.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QTest>

namespace feedscope::ui {
namespace {

class WholeNumberBoxTest : public testing::TestWithParam<const char*> {
 protected:
  WholeNumberBoxTest() {
    box.setLocale(QLocale(GetParam()));
    box.setRange(1, 2'000'000);
    box.setGroupSeparatorShown(true);
    box.setValue(7);
  }

  int typed(const QString& text) {
    auto* line = box.findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    return box.value();
  }

  WholeNumberBox box;
};

TEST_P(WholeNumberBoxTest, TakesDigitsWithBlanksBetweenGroups) {
  EXPECT_EQ(typed("15"), 15);
  EXPECT_EQ(typed("1 000 000"), 1'000'000);
  EXPECT_EQ(box.text(), QStringList({"1", "000", "000"}).join(QChar(0x202F)));
  EXPECT_EQ(box.valueFromText(box.text()), 1'000'000);
}

TEST_P(WholeNumberBoxTest, WhatIsNoNumberLeavesTheValue) {
  for (const char* text : {"", "0", "-", "1,5", "1.5", "1,500", "1.500", "3 000 000", "-5"}) {
    box.setValue(7);
    EXPECT_EQ(typed(text), 7) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WholeNumberBoxTest, testing::Values("C", "en", "fr", "de"));

}  // namespace
}  // namespace feedscope::ui
