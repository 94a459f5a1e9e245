#include "ui/help/handbook_window.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <QTextBrowser>
#include <QUrl>

namespace feedscope::ui {
namespace {

class HandbookWindowTest : public testing::Test {
 protected:
  HandbookWindowTest() {
    window.setAttribute(Qt::WA_DontShowOnScreen);
    window.show_page("first-steps");
  }
  QLineEdit& search() { return *window.findChild<QLineEdit*>(); }
  QListWidget& list() { return *window.findChild<QListWidget*>(); }
  QTextBrowser& text() { return *window.findChild<QTextBrowser*>(); }
  QString heading() { return text().toPlainText().section('\n', 0, 0); }

  HandbookWindow window;
};

TEST_F(HandbookWindowTest, ShowsThePageAskedForAndListsAll) {
  EXPECT_EQ(heading(), "First steps");
  EXPECT_GT(list().count(), 10);
  EXPECT_EQ(list().currentItem()->text(), "First steps");
  window.show_page("no such page");
  EXPECT_EQ(list().currentRow(), 0);
}

TEST_F(HandbookWindowTest, WordsLeaveThePagesThatHoldThemAndEnterGoesThere) {
  const int all = list().count();
  search().setText("exit code");
  ASSERT_GT(list().count(), 0);
  EXPECT_LT(list().count(), all);
  QTest::keyClick(&search(), Qt::Key_Return);
  EXPECT_TRUE(text().textCursor().hasSelection());
  EXPECT_FALSE(text().extraSelections().isEmpty());
  search().setText("zzzzqq");
  EXPECT_EQ(list().count(), 0);
  QTest::keyClick(&search(), Qt::Key_Return);
  search().clear();
  EXPECT_EQ(list().count(), all);
}

TEST_F(HandbookWindowTest, LinksLeadToOtherPages) {
  emit text().anchorClicked(QUrl("reports.md"));
  EXPECT_EQ(list().currentItem()->data(Qt::UserRole).toString(), "reports");
  emit text().anchorClicked(QUrl("machine-files.md#times-and-positions"));
  EXPECT_EQ(list().currentItem()->data(Qt::UserRole).toString(), "machine-files");
}

}  // namespace
}  // namespace feedscope::ui
