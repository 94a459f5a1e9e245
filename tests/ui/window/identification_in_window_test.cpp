#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <QTest>
#include <QTreeWidget>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/identification/fit_choice.h"
#include "ui/identification/identification_view.h"
#include "ui/identification/recordings_box.h"
#include "ui/identification/result_box.h"
#include "ui/identification/test_program_dialog.h"
#include "ui/session/session_file.h"
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
  EXPECT_EQ(panel().message(), "Cancelled.");
}

/// A search takes minutes: its result is worth the question whether to save it.
TEST_F(IdentificationInWindow, ItsResultComesBackWithTheSession) {
  model.traces().add(files.write("scope.csv", test::trace_table(model.shown()->run)));
  wait();
  panel().choice().tick_none();
  panel().choice().parameters().topLevelItem(0)->setCheckState(0, Qt::Checked);
  QCoreApplication::processEvents();
  panel().identify();
  wait();
  ASSERT_NE(panel().result().chosen(), nullptr) << panel().message().toStdString();
  panel().add_table(files.write("times.csv", "section,seconds\n2-2,1\n3-3,1\n4-4,1\n5-5,1.5\n"));
  panel().recordings().list().item(1)->setCheckState(Qt::Unchecked);
  EXPECT_TRUE(window.session().changed());
  const std::filesystem::path file = files.write("part.feedscope", "");
  write_session(window.session().capture(), file);
  const QString found = panel().result().verdict();

  Workbench other{shipped_machines(), make_setup({})};
  MainWindow again(other, RenderBackend::software);
  again.open(file);
  const auto rest = [&] {
    return QTest::qWaitFor([&] { return !other.busy() && !again.busy() && !other.traces().busy(); },
                           patience);
  };
  ASSERT_TRUE(rest());
  IdentificationView& shown = again.part<IdentificationView>();
  ASSERT_NE(shown.result().chosen(), nullptr);
  EXPECT_EQ(shown.result().verdict(), found);
  EXPECT_TRUE(shown.result().parameters().isEnabled()) << "of the same recording";
  ASSERT_EQ(shown.recordings().list().count(), 2);
  EXPECT_EQ(shown.recordings().list().item(1)->checkState(), Qt::Unchecked);
  EXPECT_EQ(shown.choice().starts()[0].keys.size(), 1U);
  EXPECT_FALSE(again.session().changed());
  shown.show_as_run();
  ASSERT_TRUE(rest());
  EXPECT_EQ(other.runs().items().size(), 2U) << "what was found can still be run";

  // As the language or the units are changed.
  MainWindow remade(other, RenderBackend::software);
  remade.take_over(again.hand_over());
  IdentificationView& kept = remade.part<IdentificationView>();
  ASSERT_NE(kept.result().chosen(), nullptr);
  EXPECT_TRUE(kept.result().parameters().isEnabled());
  EXPECT_EQ(kept.recordings().list().count(), 2);
  EXPECT_EQ(kept.choice().starts()[0].keys, shown.choice().starts()[0].keys);
}

/// The first simulation of a long program takes its time, or fails.
TEST_F(IdentificationInWindow, ATableThatIsOpenedBeforeTheRunIsThereStays) {
  const std::filesystem::path file = files.write("part.feedscope", "");
  write_session(window.session().capture(), file);
  const std::filesystem::path times =
      files.write("times.csv", "section,seconds\n2-2,1\n3-3,1\n4-4,1\n5-5,1.5\n");
  Workbench other{shipped_machines(), make_setup({})};
  MainWindow again(other, RenderBackend::software);
  IdentificationView& shown = again.part<IdentificationView>();
  std::size_t saved = 0;
  QObject::connect(&other, &Workbench::program_changed, &again, [&] {
    if (other.program() != nullptr && other.shown() == nullptr && saved == 0) {
      shown.add_table(times);
      saved = again.session().capture().identification.tables.size();
    }
  });
  again.open(file);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return other.shown() != nullptr && !other.busy() && !again.busy(); }, patience));
  EXPECT_EQ(saved, 1U) << "a session that is saved in that time has it";
  EXPECT_EQ(shown.recordings().list().count(), 1);
  EXPECT_TRUE(again.session().changed());
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
