#include "ui/window/menus/presentation.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QTextBrowser>
#include <QToolBar>

#include "core/base/data_folder.h"
#include "tests/ui/patience.h"
#include "ui/charts/charts_panel.h"
#include "ui/lessons/lesson_view.h"
#include "ui/program_text/program_panel.h"
#include "ui/setup/setup_view.h"
#include "ui/theme/theme.h"
#include "ui/theme/type_size.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"
#include "ui/window/panels/saved_layout.h"

namespace feedscope::ui {
namespace {

class PresentationTest : public testing::Test {
 protected:
  PresentationTest() {
    apply_theme();
    desk().unlock(true);
    window.resize(1280, 800);
    window.show();
    settle();
  }
  static void settle() {
    for (int i = 0; i < 12; ++i) {
      QCoreApplication::processEvents();
    }
  }
  void present(bool on) {
    window.presentation().set_on(on);
    settle();
  }
  void open(const std::filesystem::path& lesson) {
    QSignalSpy opened(&desk(), &LessonDesk::opened);
    desk().open(lesson);
    ASSERT_TRUE(opened.wait(patience));
    settle();
  }
  LessonDesk& desk() { return window.part<LessonView>().desk(); }
  QDockWidget& dock(const char* id) { return *window.findChild<QDockWidget*>(id); }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

double share_of(const QWidget& part, const QWidget& whole) {
  return static_cast<double>(part.width()) * part.height() /
         (static_cast<double>(whole.width()) * whole.height());
}

/// Names what of a lesson's labels and buttons cannot be seen whole; "" if nothing.
std::string cut_part(const LessonView& view) {
  for (const QWidget* part : view.findChildren<QWidget*>()) {
    const auto* label = qobject_cast<const QLabel*>(part);
    const auto* button = qobject_cast<const QAbstractButton*>(part);
    if (!part->isVisible() || (label == nullptr && button == nullptr)) {
      continue;
    }
    const QString text = label != nullptr ? label->text() : button->text();
    if (text.isEmpty()) {
      continue;
    }
    const int left = part->mapTo(&view, QPoint(0, 0)).x();
    const bool fits = label != nullptr
                          ? part->height() >= std::max(label->heightForWidth(part->width()), 0) &&
                                part->width() >= part->minimumSizeHint().width()
                          : part->width() >= part->sizeHint().width();
    if (!fits || left < 0 || left + part->width() > view.width()) {
      return (text + QStringLiteral(" at %1 + %2 of %3").arg(left).arg(part->width()).arg(view.width()))
          .toStdString();
    }
  }
  return "";
}

/// Sizes of screens in their pixels; QT_SCALE_FACTOR, with which this is also run, makes logical ones of
/// them.
constexpr std::array screens{QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080), QSize(3840, 2160)};

TEST_F(PresentationTest, EveryLessonFitsEveryScreenAndLeavesThe3dViewAndChartsTheirShare) {
  constexpr double least_view = 0.18;
  constexpr double least_charts = 0.2;
  constexpr double least_both = 0.5;
  present(true);
  window.setUpdatesEnabled(false);  // places and sizes do not wait for what is drawn in them
  for (const std::filesystem::path& lesson : shipped_lessons()) {
    open(lesson);
    for (const QSize& screen : screens) {
      const QSize size = screen / window.devicePixelRatioF();
      window.resize(size);
      settle();
      LessonView& shown = window.part<LessonView>();
      for (std::size_t question = 0; question < desk().lesson()->questions.size(); ++question) {
        desk().choose_question(question);
        settle();
        for (int page = 0; page < 20 && !shown.question().isVisible(); ++page) {  // reads the text first
          shown.step(true);
          settle();
        }
        SCOPED_TRACE(testing::Message() << lesson.filename() << ", question " << question + 1 << ", "
                                        << size.width() << " x " << size.height());
        ASSERT_EQ(window.size(), size) << "the window grew beyond the screen";
        for (const QDockWidget* one : window.findChildren<QDockWidget*>()) {
          if (one->isVisible()) {
            EXPECT_TRUE(window.rect().contains(one->geometry())) << one->objectName().toStdString();
          }
        }
        EXPECT_EQ(cut_part(shown), "");
        const QWidget& room = *shown.findChild<QScrollArea*>()->viewport();
        for (const QWidget* part : QList<QWidget*>{&shown.question(), shown.values().back()}) {
          EXPECT_TRUE(room.rect().contains(QRect(part->mapTo(&room, QPoint()), part->size())))
              << "the question is cut";
        }
        EXPECT_EQ(shown.question().verticalScrollBar()->maximum(), 0);
        const double view = share_of(window.scenes(), window);
        const double charts = share_of(dock("charts"), window);
        EXPECT_GE(view, least_view);
        EXPECT_GE(charts, least_charts);
        EXPECT_GE(view + charts, least_both);
      }
    }
  }
}

/// Its tables are as high as their type, and none lies on another one.
TEST_F(PresentationTest, TheMachinePanelIsNotCrushed) {
  open(find_lesson("8"));
  desk().set_up_window();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && model.shown() != nullptr; }, patience));
  present(true);
  dock("machine").show();
  SetupView& machine = window.part<SetupView>();
  for (const QSize& screen : screens) {
    window.resize(screen / window.devicePixelRatioF());
    settle();
    SCOPED_TRACE(testing::Message() << screen.width() << " x " << screen.height());
    ASSERT_TRUE(machine.drives()->isVisible()) << "the machine of the lesson has drives";
    EXPECT_GE(machine.drives()->rowHeight(0), machine.drives()->fontMetrics().height());
    const QList<QTableView*> tables{machine.axes(), machine.drives(), machine.settings()};
    for (qsizetype i = 0; i + 1 < tables.size(); ++i) {
      EXPECT_LT(tables[i]->geometry().bottom(), tables[i + 1]->geometry().top()) << i;
    }
    EXPECT_GT(machine.settings()->height(), 3 * machine.settings()->fontMetrics().height());
  }
}

TEST_F(PresentationTest, TypeIsTheSameShareOfEveryWindow) {
  EXPECT_DOUBLE_EQ(Presentation::type_scale({1280, 800}), 1.5);
  EXPECT_DOUBLE_EQ(Presentation::type_scale({2560, 1600}), 3);
  EXPECT_DOUBLE_EQ(Presentation::type_scale({1920, 800}), 1.5) << "the narrower way counts";
  present(true);
  const int usual = 12;
  EXPECT_EQ(window.part<ChartsPanel>().font().pixelSize(), usual * 3 / 2);
  window.resize(2560, 1600);
  settle();
  EXPECT_EQ(window.part<ChartsPanel>().font().pixelSize(), usual * 3);
  EXPECT_EQ(window.part<ChartsPanel>().header(0).font().pixelSize(), 33) << "its own 11, three times";
  EXPECT_EQ(window.part<LessonView>().font().pixelSize(), usual * 3);
}

TEST_F(PresentationTest, LeavingItBringsTheLayoutBack) {
  dock("messages").raise();
  dock("program").hide();
  window.part<ProgramPanel>().view().set_font_size(15);
  window.resizeDocks({&dock("charts")}, {300}, Qt::Vertical);
  settle();
  dock("messages").show();
  dock("messages").raise();
  settle();
  const QByteArray layout = window.saveState();
  const QSize size = window.size();
  const int height = dock("messages").height();
  present(true);
  EXPECT_TRUE(dock("lesson").isVisible());
  EXPECT_TRUE(dock("charts").isVisible());
  EXPECT_FALSE(dock("messages").isVisible());
  for (const QToolBar* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    EXPECT_FALSE(bar->isVisible());
  }
  EXPECT_EQ(window.part<ProgramPanel>().view().font_size(), 23);
  EXPECT_EQ(window.presentation().usual_layout(), layout);
  EXPECT_EQ(window.presentation().usual_program_type(), 15);
  window.resize(1000, 700);
  settle();
  window.resize(size);
  settle();
  present(false);
  EXPECT_EQ(window.size(), size);
  EXPECT_EQ(window.saveState(), layout);
  EXPECT_EQ(dock("messages").height(), height);
  EXPECT_TRUE(dock("messages").isVisible());
  EXPECT_FALSE(dock("program").isVisible());
  EXPECT_EQ(window.part<ProgramPanel>().view().font_size(), 15);
  EXPECT_EQ(window.part<ChartsPanel>().font().pixelSize(), 12);
  for (const QToolBar* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
    EXPECT_TRUE(bar->isVisible());
  }
}

TEST_F(PresentationTest, ACommandAndItsKeySwitchIt) {
  QAction& action = *window.presentation().actions().front();
  EXPECT_EQ(action.shortcut(), QKeySequence("F12"));
  action.trigger();
  EXPECT_TRUE(window.presentation().on());
  action.trigger();
  EXPECT_FALSE(window.presentation().on());
}

/// Also where what is typed goes to a field.
TEST_F(PresentationTest, TheKeysOfAPresenterGoThroughTheLesson) {
  open(find_lesson("6"));
  LessonView& lesson = window.part<LessonView>();
  window.activateWindow();
  QTest::keyClick(&window, Qt::Key_PageDown);
  EXPECT_FALSE(lesson.answer_button().isChecked()) << "only while presenting";
  present(true);
  EXPECT_EQ(window.menuBar()->height(), 0);
  EXPECT_FALSE(window.statusBar()->isVisible());
  EXPECT_FALSE(lesson.question().isVisible()) << "the text comes first";
  for (int page = 0; page < 10 && !lesson.question().isVisible(); ++page) {
    QTest::keyClick(&window, Qt::Key_PageDown);
    settle();
  }
  QTest::keyClick(&window, Qt::Key_PageDown);
  settle();
  EXPECT_TRUE(lesson.answer_button().isChecked());
  lesson.own_answer().setFocus();
  for (int page = 0; page < 10 && desk().question() == 0; ++page) {
    QTest::keyClick(&lesson.own_answer(), Qt::Key_PageDown);  // reads the answer to its end first
    settle();
  }
  EXPECT_EQ(desk().question(), 1U);
  QTest::keyClick(&lesson.own_answer(), Qt::Key_PageUp);
  EXPECT_EQ(desk().question(), 0U);
  QTest::keyClick(&lesson.own_answer(), Qt::Key_F12);
  EXPECT_FALSE(window.presentation().on()) << "the key works without its menu";
  settle();
  EXPECT_GT(window.menuBar()->height(), 0);
  EXPECT_TRUE(window.statusBar()->isVisible());
}

TEST_F(PresentationTest, ASessionRemembersItWithTheUsualLayout) {
  model.open(data_folder() / "resources/programs/tapie_circle_30.nc");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && model.shown() != nullptr; }, patience));
  dock("runs").show();
  dock("runs").raise();
  settle();
  const QByteArray layout = window.saveState();
  present(true);
  const Session session = window.session().capture();
  EXPECT_TRUE(session.presentation);
  EXPECT_EQ(checked_state(session.layout), layout);
  present(false);
  EXPECT_FALSE(window.session().capture().presentation);
  window.session().show(session);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && model.shown() != nullptr; }, patience));
  settle();
  EXPECT_TRUE(window.presentation().on());
  EXPECT_EQ(window.presentation().usual_layout(), layout);
  present(false);
  EXPECT_TRUE(dock("runs").isVisible());
  EXPECT_TRUE(dock("program").isVisible());
  EXPECT_FALSE(dock("lesson").isVisible());
}

TEST_F(PresentationTest, TypeIsUsualAgainWhenThePresentingWindowIsGone) {
  {
    MainWindow other(model, RenderBackend::software);
    other.presentation().set_on(true);
    EXPECT_GT(TypeSize::of_application().scale(), 1);
  }
  EXPECT_DOUBLE_EQ(TypeSize::of_application().scale(), 1);
}

}  // namespace
}  // namespace feedscope::ui
