#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <QTest>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/identification/identification_view.h"
#include "ui/identification/recordings_box.h"
#include "ui/identification/test_program_dialog.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

class IdentificationInWindow : public testing::Test {
 protected:
  IdentificationInWindow() {
    window.resize(1280, 800);
    window.show();
    model.open(files.write("part.nc", test::small_program));
    wait();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
  }
  IdentificationView& panel() { return window.part<IdentificationView>(); }

  const test::WrittenFiles files;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(IdentificationInWindow, ATableOfSectionTimesThatIsDroppedGoesToItsPanel) {
  EXPECT_FALSE(panel().isVisible());
  window.open(files.write("times.csv", "section,seconds\n2-2,1\n3-3,1\n4-4,1\n5-5,1.5\n"));
  QCoreApplication::processEvents();
  EXPECT_TRUE(panel().isVisible());
  ASSERT_EQ(panel().recordings().list().count(), 1);
  EXPECT_EQ(panel().recordings().list().item(0)->text(), "times.csv: 4 section times");
  EXPECT_EQ(to_qstring(model.file().filename()), "part.nc") << "it is no program";
}

TEST_F(IdentificationInWindow, TheTestProgramThatWasWrittenIsOpened) {
  TestProgramDialog& dialog = panel().ask_for_test_program();
  ASSERT_TRUE(dialog.write(files.write("test.nc", "")));
  emit dialog.open_wanted(files.write("test.nc", test::small_program));
  wait();
  EXPECT_EQ(to_qstring(model.file().filename()), "test.nc");
  dialog.reject();
}

TEST_F(IdentificationInWindow, EscCancelsTheSearch) {
  model.traces().add(files.write("scope.csv", test::trace_table(model.shown()->run)));
  wait();
  panel().identify();
  ASSERT_TRUE(panel().busy());
  emit window.cancel_wanted();
  wait();
  EXPECT_EQ(panel().state(), "Cancelled.");
}

TEST_F(IdentificationInWindow, EverydayWordsFindIt) {
  const QString words = panel().panel_actions().first()->property(everyday_words_property).toString();
  for (const char* word : {"identify", "machine", "parameters", "trace"}) {
    EXPECT_THAT(words.toStdString(), testing::HasSubstr(word));
  }
}

/// All of it can be come to, in the order in which it is read.
TEST_F(IdentificationInWindow, TabGoesDownThePanel) {
  model.traces().add(files.write("scope.csv", test::trace_table(model.shown()->run)));
  wait();
  emit panel().attention_wanted();
  QCoreApplication::processEvents();
  window.activateWindow();
  panel().recordings().list().setFocus();
  int height = -1;
  int stops = 0;
  for (; panel().isAncestorOf(QApplication::focusWidget()) && stops < 50; ++stops) {
    const QWidget* at = QApplication::focusWidget();
    const int y = at->mapTo(&panel(), QPoint(0, 0)).y();
    EXPECT_GE(y, height - 4) << at->metaObject()->className() << " " << at->accessibleName().toStdString();
    height = y;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  EXPECT_GE(stops, 10);
}

}  // namespace
}  // namespace feedscope::ui
