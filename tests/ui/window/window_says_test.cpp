// What the window tells and asks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <fstream>
#include <set>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/annotations/annotations_view.h"
#include "ui/charts/charts_panel.h"
#include "ui/contour/contour_view.h"
#include "ui/language/language.h"
#include "ui/lessons/lesson_view.h"
#include "ui/messages/diagnostics_view.h"
#include "ui/runs/run_notice.h"
#include "ui/runs/runs_view.h"
#include "ui/setup/setup_bar.h"
#include "ui/setup/setup_view.h"
#include "ui/slow_places/slow_places_view.h"
#include "ui/study/study_view.h"
#include "ui/theme/theme.h"
#include "ui/why/why_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"
#include "ui/window/panels/start_page.h"

namespace feedscope::ui {
namespace {

class WindowSaysTest : public testing::Test {
 protected:
  WindowSaysTest() { window.show(); }

  void open(const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << text;
    model.open(file);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
    QCoreApplication::processEvents();
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  const QTemporaryDir folder;
};

TEST_F(WindowSaysTest, WhereNothingIsShownTheViewSaysWhy) {
  EXPECT_EQ(window.part<RunNotice>().text(), "");
  for (const char* nothing : {"", "Dear reader,\nnothing moves here.\n", "G21 G90\nM30\n", "%\n"}) {
    open(nothing);
    EXPECT_THAT(window.part<RunNotice>().text().toStdString(), testing::HasSubstr("Nothing in part.nc moves"))
        << nothing;
    EXPECT_TRUE(window.part<RunNotice>().again()->isHidden()) << "simulating it again would change nothing";
  }
  open(std::string(500, '\x01'));
  EXPECT_THAT(window.part<RunNotice>().text().toStdString(), testing::HasSubstr("is not a text file"));
  EXPECT_FALSE(window.part<RunNotice>().again()->isHidden());
  EXPECT_EQ(window.part<RunNotice>().again()->text().toStdString(), "Read again");
  open(test::small_program);
  EXPECT_EQ(window.part<RunNotice>().text(), "");
}

TEST_F(WindowSaysTest, CtrlCCopiesEveryTableOfResultsWhole) {
  open(test::small_program);
  window.part<StudyView>().run();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window.part<StudyView>().busy(); }, patience));
  for (QWidget* panel : std::initializer_list<QWidget*>{
           &window.part<RunsView>(), &window.part<StudyView>(), &window.part<ContourView>(),
           &window.part<SlowPlacesView>(), &window.part<DiagnosticsView>(), &window.part<AnnotationsView>(),
           &window.part<WhyView>()}) {
    // Not the list of a combo box.
    const auto views = panel->findChildren<QAbstractItemView*>();
    const auto named =
        std::ranges::find_if(views, [](const auto* v) { return !v->accessibleName().isEmpty(); });
    ASSERT_NE(named, views.end());
    const QAbstractItemView* view = *named;
    const QList<QAction*> actions = view->actions();
    const auto copy = std::ranges::find(actions, QKeySequence(QKeySequence::Copy), &QAction::shortcut);
    ASSERT_NE(copy, actions.end()) << view->accessibleName().toStdString();
    (*copy)->trigger();
    EXPECT_EQ(QApplication::clipboard()->text().count('\n'), view->model()->rowCount() + 1)
        << view->accessibleName().toStdString();
  }
}

TEST_F(WindowSaysTest, TheStudyListsSettingsByTheirTitles) {
  const QComboBox& settings = *window.part<StudyView>().key();
  ASSERT_GT(settings.count(), 5);
  for (int i = 0; i < settings.count(); ++i) {
    EXPECT_FALSE(settings.itemText(i).contains('_')) << settings.itemText(i).toStdString();
    EXPECT_EQ(settings.itemData(i, Qt::ToolTipRole), settings.itemData(i)) << "the key of command lines";
  }
  EXPECT_GE(settings.findText("X Jerk [m/s³]"), 0);
}

TEST_F(WindowSaysTest, AnEmptyStartSaysWhatToDoFirst) {
  auto& page = window.part<StartPage>();
  EXPECT_TRUE(page.isVisible());
  const QRect around(QPoint(), window.size());
  EXPECT_TRUE(around.contains(page.geometry()));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !page.busy() && !window.part<LessonView>().desk().busy(); }, patience));
  for (const SampleProgram& sample : start_samples()) {
    EXPECT_TRUE(std::filesystem::exists(sample.file)) << sample.file;
  }
  QApplication::processEvents();  // lays the lessons out
  // By Tab through all of them, samples with their pictures, lessons too, and never out of the page.
  const std::size_t count = page.buttons().size();
  EXPECT_GE(count, 3 + start_samples().size() + 12);
  std::set<QWidget*> reached;
  std::size_t pictures = 0;
  for (std::size_t i = 0; i < count; ++i) {
    QWidget* focus = page.focusWidget();
    ASSERT_NE(focus, nullptr);
    pictures +=
        reached.insert(focus).second && !qobject_cast<QAbstractButton*>(focus)->icon().isNull() ? 1 : 0;
    QTest::keyClick(focus, Qt::Key_Tab);
  }
  EXPECT_EQ(reached.size(), count);
  EXPECT_EQ(pictures, start_samples().size());
  open(test::small_program);
  EXPECT_FALSE(page.isVisible());
}

/// As a page that was made in the theme, lines and buttons included.
TEST_F(WindowSaysTest, TheStartPageTakesTheColoursOfAnotherTheme) {
  const auto picture = [](MainWindow& of) {
    auto& page = of.part<StartPage>();
    of.resize(1280, 800);
    of.show();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return !page.busy() && !of.part<LessonView>().desk().busy(); }, patience));
    QApplication::processEvents();
    page.setFocus();
    return page.grab().toImage();
  };
  const QImage light = picture(window);
  apply_theme(ThemeKind::dark);
  const QImage changed = picture(window);
  MainWindow made_dark(model, RenderBackend::software);
  const QImage dark = picture(made_dark);
  apply_theme(ThemeKind::light);
  EXPECT_NE(changed, light);
  EXPECT_EQ(changed, dark);
}

TEST_F(WindowSaysTest, FiveNamesOfPanelsFitBesideEachOther) {
  for (const char* language : {"en", "fr"}) {
    install_language(language);
    MainWindow other(model, RenderBackend::software);
    other.resize(1280, 800);
    other.show();
    emit other.part<LessonView>().attention_wanted();
    QApplication::processEvents();
    int most = 0;
    for (const QTabBar* tabs : other.findChildren<QTabBar*>()) {
      if (tabs->isVisible() && tabs->count() > 1) {
        most = std::max(most, tabs->count());
        EXPECT_LE(tabs->tabRect(tabs->count() - 1).right(), tabs->width()) << language;
      }
    }
    EXPECT_EQ(most, 5) << "a lesson is beside four others";
  }
  install_language("en");
}

TEST_F(WindowSaysTest, TheStartPageMakesWayForWhatIsAskedFor) {
  auto& page = window.part<StartPage>();
  emit window.part<LessonView>().attention_wanted();
  EXPECT_FALSE(page.isVisible());
  page.open();
  emit window.cancel_wanted();  // Escape
  EXPECT_FALSE(page.isVisible());
}

TEST_F(WindowSaysTest, SettingsWithoutAValueAreShownWhenWanted) {
  QTableView& settings = *window.part<SetupView>().settings();
  const auto rows_shown = [&] {
    int count = 0;
    for (int row = 0; row < settings.model()->rowCount(); ++row) {
      count += settings.isRowHidden(row) ? 0 : 1;
    }
    return count;
  };
  const int all = settings.model()->rowCount();
  const int without = all - rows_shown();
  ASSERT_GT(without, 5);
  EXPECT_THAT(window.part<SetupView>().unset()->toolTip().toStdString(),
              testing::AllOf(testing::HasSubstr("Times of tool changes"),
                             testing::Not(testing::HasSubstr("rotary"))));
  window.part<SetupView>().unset()->click();
  EXPECT_EQ(rows_shown(), all);
  model.setup().set("tool_change_time_s", 4.0);
  window.part<SetupView>().unset()->click();
  EXPECT_EQ(rows_shown(), all - without + 1) << "one has a value now";
  window.part<SetupView>().show_key("home_x_mm");
  EXPECT_EQ(rows_shown(), all) << "what is asked for is not hidden";
}

TEST_F(WindowSaysTest, SentencesOfTheMachinePanelAreWholeAtAnyWidth) {
  open(test::small_program);
  emit window.part<SetupView>().attention_wanted();
  window.part<SetupView>().show_remarks(
      {{Remark::About::time,
        Message::as_written(QString("The program asks for words ").repeated(9).toStdString())},
       {Remark::About::values, Message::as_written("And for more.")}});
  for (const int width : {240, 300, 371, 500}) {
    window.resizeDocks({window.findChild<QDockWidget*>("machine")}, {width}, Qt::Horizontal);
    QTest::qWait(20);
    for (const QLabel* label : window.part<SetupView>().findChildren<QLabel*>()) {
      if (label->isVisible() && label->wordWrap()) {
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
      }
    }
  }
}

/// Where Tab stops, one sees it: the widget, or what holds it, looks different with the focus.
TEST_F(WindowSaysTest, TabStopsOnlyWhereTheFocusIsSeenAndGoesThroughEveryPanel) {
  window.resize(1600, 1000);
  open(test::small_program);
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  std::set<QWidget*> checked;
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QTest::qWait(100);
    window.findChild<SetupBar*>()->findChild<QComboBox*>()->setFocus(Qt::TabFocusReason);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    std::set<QWidget*> seen;
    bool reached = dock->findChild<QAbstractItemView*>() == nullptr;
    const QWidget* last = nullptr;
    int links = 0;  // of a text, which Tab goes through one by one
    constexpr int max_links = 50;
    for (QWidget* at = QApplication::focusWidget();
         at != nullptr && (seen.insert(at).second || (at == last && ++links < max_links));
         at = QApplication::focusWidget()) {
      last = at;
      reached = reached || dock->isAncestorOf(at);
      if (checked.insert(at).second) {
        QWidget* holder = at->parentWidget() != nullptr ? at->parentWidget() : at;
        const QImage with = holder->grab().toImage();
        at->clearFocus();
        const bool same = holder->grab().toImage() == with;
        at->setFocus(Qt::TabFocusReason);
        EXPECT_FALSE(same) << at->metaObject()->className() << " \"" << at->accessibleName().toStdString()
                           << "\" in " << holder->metaObject()->className() << ' ' << at->x() << ','
                           << at->y() << ' ' << at->width() << 'x' << at->height() << " with "
                           << dock->objectName().toStdString();
      }
      QTest::keyClick(at, Qt::Key_Tab);
    }
    EXPECT_TRUE(reached) << dock->windowTitle().toStdString();
  }
  EXPECT_GT(checked.size(), 40U);
}

TEST_F(WindowSaysTest, NoTabOfAPanelIsCut) {
  window.resize(1280, 800);
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    dock->show();
  }
  open(test::small_program);
  QTest::qWait(50);
  int seen = 0;
  for (const QTabBar* tabs : window.findChildren<QTabBar*>()) {
    for (int i = 0; i < tabs->count(); ++i, ++seen) {
      EXPECT_GE(tabs->tabRect(i).width(), tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)))
          << tabs->tabText(i).toStdString();
    }
  }
  EXPECT_GT(seen, 8);
}

TEST_F(WindowSaysTest, NoSentenceOfAPanelIsCut) {
  open(
      "0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S9000 F480\n2 L Z-10 FMAX M91\n3 L X+0 Y+0 Z+0 F900 M3\n"
      "4 L X+10 R0\n5 END PGM A MM\n");
  for (const int width : {1280, 1600, 2400}) {
    window.resize(width, 1000);
    int seen = 0;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      dock->raise();
      QCoreApplication::processEvents();
      for (const QLabel* label : dock->findChildren<QLabel*>()) {
        if (label->isVisible() && label->wordWrap() && !label->text().isEmpty()) {
          EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
          ++seen;
        }
      }
    }
    EXPECT_GE(seen, 3);
  }
}

TEST_F(WindowSaysTest, ACurveSwitchedOffIsOnAgainForAnotherProgram) {
  open(test::small_program);
  window.part<ChartsPanel>().show_curve(0, 1, false);
  model.reload();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
  EXPECT_FALSE(window.part<ChartsPanel>().chart(0).curve_shown(1)) << "the same program";
  const std::filesystem::path other = std::filesystem::path(folder.path().toStdString()) / "other.nc";
  std::ofstream(other) << test::small_program;
  window.open(other);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
  EXPECT_TRUE(window.part<ChartsPanel>().chart(0).curve_shown(1));
  window.part<ChartsPanel>().show_curve(0, 1, false);
  EXPECT_TRUE(for_any_run(window.part<ChartsPanel>().state()).hidden.isEmpty()) << "kept for the next start";
}

TEST_F(WindowSaysTest, AnotherLanguageNeedsAnotherWindow) {
  const QString before = chosen_language();
  const QSignalSpy wanted(&window, &MainWindow::remake_wanted);
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    if (listed.action->text().startsWith(QStringLiteral("Fran"))) {
      listed.action->trigger();
    }
  }
  EXPECT_EQ(wanted.count(), 1);
  EXPECT_EQ(chosen_language(), "fr");
  choose_language(before);
}

}  // namespace
}  // namespace feedscope::ui
