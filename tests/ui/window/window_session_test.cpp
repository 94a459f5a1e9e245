#include "ui/window/window_session.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/annotations/annotations_view.h"
#include "ui/charts/charts_panel.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

struct Window {
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};

  Window() {
    window.resize(1280, 800);
    window.show();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && model.shown() != nullptr; }, patience));
    QCoreApplication::processEvents();
  }
};

class WindowSessionTest : public testing::Test {
 protected:
  WindowSessionTest() {
    QLocale::setDefault(QLocale::c());
    std::ofstream(program_) << test::small_program;
  }

  /// As a user would set it up.
  void set_up(Window& w) {
    w.window.open(program_);
    w.wait();
    w.model.set_tolerance(0.02);
    w.model.runs().duplicate(0);
    w.model.set_tolerance(0.005);
    w.wait();
    const double duration = w.model.shown()->run.trajectory->duration();
    w.model.cursor().set_time(duration / 3);
    w.window.scene().scene().set_standard_view(StandardView::top);
    w.window.part<ChartsPanel>().range().show(duration / 4, duration / 2);
    w.window.part<AnnotationsView>()
        .panel_actions()[static_cast<qsizetype>(AnnotationKind::callout)]
        ->trigger();
  }

  QTemporaryDir folder_;
  std::filesystem::path program_ = std::filesystem::path(folder_.path().toStdString()) / "part.nc";
  std::filesystem::path file_ = std::filesystem::path(folder_.path().toStdString()) / "part.feedscope";
};

TEST_F(WindowSessionTest, AnotherWindowShowsTheSame) {
  Session saved;
  {
    Window first;
    set_up(first);
    saved = first.window.session().capture();
    write_session(saved, file_);
  }
  Window second;
  second.window.open(file_);
  second.wait();
  Session again = second.window.session().capture();
  ASSERT_TRUE(again.charts.time);
  EXPECT_DOUBLE_EQ(again.charts.time->lower, saved.charts.time->lower);  // but for rounding
  EXPECT_DOUBLE_EQ(again.charts.time->upper, saved.charts.time->upper);
  again.charts.time = saved.charts.time;
  const std::filesystem::path folder = file_.parent_path();
  EXPECT_EQ(session_bytes(again, folder).toStdString(), session_bytes(saved, folder).toStdString());
  EXPECT_EQ(second.window.session().file(), file_);
  EXPECT_TRUE(second.window.windowTitle().startsWith("part.feedscope"));
}

TEST_F(WindowSessionTest, KnowsWhetherThereIsSomethingToSave) {
  Window w;
  EXPECT_FALSE(w.window.session().changed());
  w.window.open(program_);
  w.wait();
  EXPECT_FALSE(w.window.session().changed());
  set_up(w);
  EXPECT_TRUE(w.window.session().changed());
  write_session(w.window.session().capture(), file_);
  w.model.annotations().replace({});
  w.model.runs().remove(1);
  w.window.open(file_);
  w.wait();
  EXPECT_FALSE(w.window.session().changed());
  w.model.annotations().remove(w.model.annotations().items().at(0).id);
  EXPECT_TRUE(w.window.session().changed());
}

TEST_F(WindowSessionTest, ASessionThatCannotBeUsedChangesNothingAndIsReported) {
  Window w;
  w.window.open(program_);
  w.wait();
  std::ofstream(file_) << "{\"format\": \"feedscope-session\", \"version\": 99}";
  QSignalSpy failed(&w.window.session(), &WindowSession::failed);
  w.window.open(file_);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("newer Feedscope"));
  EXPECT_NE(w.model.shown(), nullptr);
  EXPECT_EQ(w.model.file(), program_);
}

TEST_F(WindowSessionTest, AProgramOpenedByItselfLeavesTheSession) {
  Window w;
  set_up(w);
  write_session(w.window.session().capture(), file_);
  w.model.annotations().replace({});
  w.model.runs().remove(1);
  w.window.open(file_);
  w.wait();
  w.window.open(program_);
  w.wait();
  EXPECT_TRUE(w.window.session().file().empty());
}

}  // namespace
}  // namespace feedscope::ui
