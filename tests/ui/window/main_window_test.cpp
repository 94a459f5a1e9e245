#include "ui/window/main_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>
#include <fstream>
#include <map>

#include "core/base/data_folder.h"
#include "tests/support/folders.h"
#include "tests/ui/own_tip.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/contour/contour_view.h"
#include "ui/lessons/lesson_view.h"
#include "ui/messages/diagnostics_view.h"
#include "ui/playback/playback_bar.h"
#include "ui/program_text/program_panel.h"
#include "ui/runs/run_notice.h"
#include "ui/runs/runs_view.h"
#include "ui/setup/setup_view.h"
#include "ui/why/why_view.h"
#include "ui/window/menus/help_menu.h"
#include "ui/window/panels/panel_states.h"

namespace feedscope::ui {
namespace {

class MainWindowTest : public testing::Test {
 protected:
  MainWindowTest() {
    window.resize(1280, 800);
    window.show();
    open(test::small_program);
  }

  void open(const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << text;
    model.open(file);
    wait_until_idle();
  }

  void wait_until_idle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
    QCoreApplication::processEvents();
    window.part<ChartsPanel>().refresh();
  }

  const Trajectory& trajectory() const { return *model.shown()->run.trajectory; }
  double duration() const { return trajectory().duration(); }

  /// Where a chart shows a time, half way up.
  QPoint point_in(KinematicChart& chart, double time) const {
    return {static_cast<int>(std::lround(chart.pixel_of(time))), chart.height() / 2};
  }
  void click_chart(std::size_t i, double time) {
    KinematicChart& chart = window.part<ChartsPanel>().chart(i);
    QTest::mouseClick(&chart, Qt::LeftButton, {}, point_in(chart, time));
  }
  /// A pixel of a chart in seconds.
  double pixel_time() { return duration() / window.part<ChartsPanel>().chart(0).column_count(); }

  QWidget* scene_canvas() { return window.scene().findChild<QWidget*>(); }
  QPoint point_in_scene(const Vec3& position) {
    window.scene().grab();  // the camera is that of the last frame
    const Pixel pixel = window.scene().scene().pixel_of(position);
    return {static_cast<int>(std::lround(pixel[0])), static_cast<int>(std::lround(pixel[1]))};
  }
  QImage picture_around(const QPoint& point) {
    return window.scene().grab(QRect(point - QPoint(12, 12), QSize(25, 25))).toImage();
  }

  /// Types into the cell of X.jerk, as a user does.
  void type_jerk(const QString& text) {
    QTableView* table = window.part<SetupView>().axes();
    table->setFocus();
    table->setCurrentIndex(table->model()->index(2, 0));
    QTest::keyClick(table, Qt::Key_F2);
    auto* editor = table->viewport()->findChild<QWidget*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();  // the delegate commits with the next turn of the event loop
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  const QTemporaryDir folder;
};

TEST_F(MainWindowTest, ClickInAChartMovesTextAnd3dMarker) {
  for (const std::size_t i : {0U, 1U, 2U}) {
    const double time = duration() * (0.3 + 0.2 * static_cast<double>(i));
    const State expected = trajectory().state(time);
    const QPoint place = point_in_scene(expected.position);
    const QImage before = picture_around(place);
    click_chart(i, time);
    const State& state = model.cursor().state();
    EXPECT_NEAR(state.time, time, pixel_time());
    EXPECT_EQ(window.part<ProgramPanel>().view().current_line(), state.line);
    EXPECT_NEAR(*window.part<ChartsPanel>().chart(0).cursor(), state.time, 1e-12);
    EXPECT_NE(picture_around(place), before) << "the marker is not at the place";
  }
}

TEST_F(MainWindowTest, ClickOnThePathMovesChartsAndText) {
  const double time = 0.7 * duration();
  const State expected = trajectory().state(time);
  QTest::mouseClick(scene_canvas(), Qt::LeftButton, {}, point_in_scene(expected.position));
  EXPECT_NEAR((model.cursor().state().position - expected.position).norm(), 0, 0.5);
  EXPECT_NEAR(*window.part<ChartsPanel>().chart(2).cursor(), model.cursor().state().time, 1e-12);
  EXPECT_EQ(window.part<ProgramPanel>().view().current_line(), model.cursor().state().line);
}

TEST_F(MainWindowTest, ClickBesideThePathLeavesTheCursor) {
  click_chart(0, 0.4 * duration());
  const double time = model.cursor().state().time;
  QTest::mouseClick(scene_canvas(), Qt::LeftButton, {}, QPoint(3, scene_canvas()->height() - 3));
  EXPECT_EQ(model.cursor().state().time, time);
}

TEST_F(MainWindowTest, ClickOnALineMovesChartsAnd3dMarker) {
  ProgramView& program = window.part<ProgramPanel>().view();
  const QRect line = program.place_rect({4, 0});
  const QPoint place = point_in_scene(trajectory().state(trajectory().time_of_line(4)).position);
  const QImage before = picture_around(place);
  QTest::mouseClick(program.viewport(), Qt::LeftButton, {}, line.center() + QPoint(10, 0));
  EXPECT_EQ(model.cursor().state().line, 4U);
  EXPECT_EQ(program.current_line(), 4U);
  EXPECT_NEAR(*window.part<ChartsPanel>().chart(0).cursor(), trajectory().time_of_line(4), 1e-9);
  EXPECT_NE(picture_around(place), before);
}

TEST_F(MainWindowTest, ArrowKeysInTheTextMoveTheCursor) {
  model.cursor().set_line(3);
  QTest::keyClick(&window.part<ProgramPanel>().view(), Qt::Key_Down);
  EXPECT_EQ(model.cursor().state().line, 4U);
}

TEST_F(MainWindowTest, WhatWouldHelpIsShownAndBecomesARun) {
  model.cursor().set_time(0.3 * duration());
  EXPECT_FALSE(window.part<WhyView>().is_seen());
  window.part<WhyView>().try_remedies();
  QCoreApplication::processEvents();
  EXPECT_TRUE(window.part<WhyView>().is_seen());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window.part<WhyView>().busy(); }, patience));
  const RemedyTable& remedies = window.part<WhyView>().remedies();
  int row = 0;
  while (row < remedies.rowCount() && remedies.remedy(row)->changes.empty()) {
    ++row;
  }
  ASSERT_LT(row, remedies.rowCount());
  window.part<WhyView>().table()->setCurrentIndex(remedies.index(row, 0));
  window.part<WhyView>().panel_actions().back()->trigger();
  wait_until_idle();
  ASSERT_EQ(model.runs().items().size(), 2U);
  EXPECT_EQ(model.runs().current(), 1U);
  EXPECT_FALSE(model.runs().current_item().setup.edits().empty());
}

TEST_F(MainWindowTest, AnotherCauseIsAKeyAway) {
  const double before = model.cursor().state().time;
  QTest::keyClick(&window, Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_GT(model.cursor().state().time, before);
  QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_EQ(model.cursor().state().time, before);
}

TEST_F(MainWindowTest, EditingAMachineValueChangesTheCycleTimeAndUndoBringsItBack) {
  const double before = duration();
  type_jerk("3");
  wait_until_idle();
  EXPECT_DOUBLE_EQ(model.shown()->run.setup.machine.axes[0].jerk, 3000);
  EXPECT_GT(duration(), before);
  window.activateWindow();
  QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
  wait_until_idle();
  EXPECT_EQ(duration(), before);
}

TEST_F(MainWindowTest, AWrongMachineValueIsRefusedInPlace) {
  const double before = duration();
  type_jerk("-3");
  EXPECT_FALSE(model.busy());
  EXPECT_EQ(duration(), before);
  EXPECT_THAT(window.part<SetupView>().message().toStdString(), testing::HasSubstr("X Jerk"));
  EXPECT_EQ(window.part<SetupView>().axes()->model()->index(2, 0).data().toString(), "15");
}

TEST_F(MainWindowTest, WheelZoomsAtThePointerInAllCharts) {
  KinematicChart& chart = window.part<ChartsPanel>().chart(1);
  const double time = 0.25 * duration();
  const QPoint point = point_in(chart, time);
  QWheelEvent wheel(point, chart.mapToGlobal(point), {}, {0, 480}, Qt::NoButton, {}, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(&chart, &wheel);
  ViewRange& range = window.part<ChartsPanel>().range();
  EXPECT_LT(range.upper() - range.lower(), 0.5 * duration());
  window.part<ChartsPanel>().refresh();
  for (const std::size_t i : {0U, 1U, 2U}) {
    EXPECT_NEAR(window.part<ChartsPanel>().chart(i).pixel_of(time), point.x(), 1.5);
  }
}

TEST_F(MainWindowTest, DragPansAndDoubleClickShowsAll) {
  KinematicChart& chart = window.part<ChartsPanel>().chart(0);
  ViewRange& range = window.part<ChartsPanel>().range();
  range.zoom(0.25, 0.5 * duration());
  window.part<ChartsPanel>().refresh();
  const double lower = range.lower();
  const double time = model.cursor().state().time;
  const QPoint from(chart.width() / 2, 20);
  QTest::mousePress(&chart, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, from + QPoint(60, 0), chart.mapToGlobal(from), Qt::NoButton,
                   Qt::LeftButton, {});
  QCoreApplication::sendEvent(&chart, &move);
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, from + QPoint(60, 0));
  EXPECT_NEAR(range.lower(), lower - 60 * (range.upper() - range.lower()) / chart.column_count(), 1e-3);
  EXPECT_EQ(model.cursor().state().time, time) << "a drag is no click";
  QTest::mouseDClick(&chart, Qt::LeftButton, {}, from);
  EXPECT_EQ(range.lower(), 0);
  EXPECT_DOUBLE_EQ(range.upper(), duration());
}

TEST_F(MainWindowTest, PlayMovesTheCursorThroughTheRun) {
  model.playback().set_speed(0.5);
  QTest::mouseClick(window.part<PlaybackBar>().play_button(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([this] { return model.cursor().state().time > 0.02; }, patience));
  QTest::mouseClick(window.part<PlaybackBar>().play_button(), Qt::LeftButton);
  const double time = model.cursor().state().time;
  QTest::qWait(60);
  EXPECT_EQ(model.cursor().state().time, time);
}

TEST_F(MainWindowTest, AnotherProgramReplacesTextAndRun) {
  open("G21 G90 F1000\nG1 X5\n");
  EXPECT_EQ(window.part<ProgramPanel>().view().text().line_count(), 2U);
  EXPECT_NEAR(trajectory().path_length(), 5, 1e-9);
  EXPECT_EQ(model.cursor().state().time, 0);
}

TEST_F(MainWindowTest, AnotherProgramIsSeenAsAWholeAndTheSameOneWhereTheUserWas) {
  PathScene& scene = window.scene().scene();
  for (int i = 0; i < 20; ++i) {
    scene.zoom(1.2, {100, 100});
  }
  const CameraState near = scene.camera();
  model.reload();
  wait_until_idle();
  EXPECT_NEAR(scene.camera().height, near.height, 1e-6 * near.height) << "the same program is read again";
  const std::filesystem::path other = std::filesystem::path(folder.path().toStdString()) / "other.nc";
  std::ofstream(other) << "G21 G90 F1000\nG1 X500 Y0\nG1 X500 Y300\n";
  window.open(other);
  wait_until_idle();
  EXPECT_TRUE(scene.camera().fitted);
  for (const Vec3& end : {Vec3(0, 0, 0), Vec3(500, 300, 0)}) {
    EXPECT_TRUE(scene_canvas()->rect().contains(point_in_scene(end)));
  }
}

TEST_F(MainWindowTest, ProblemsOfAProgramAreListedWithTheirLine) {
  open("G21 G90 F1000\nG1 X5\nG1 Xabc\n");
  const DiagnosticsModel& list = window.part<DiagnosticsView>().model();
  ASSERT_GE(list.rowCount(), 1);
  EXPECT_THAT(list.index(0, DiagnosticsModel::place).data().toString().toStdString(),
              testing::StartsWith("3"));
}

TEST_F(MainWindowTest, NextSlowPlaceMovesTheCursorAndZoomsTheCharts) {
  const SlowPlaces& places = *model.shown()->slow_places;
  ASSERT_GE(places.places.size(), 2U);
  model.cursor().set_time(places.places[0].slowest);
  window.activateWindow();
  QTest::keyClick(&window, Qt::Key_F7);
  const SlowPlace& next = places.places[1];
  EXPECT_NEAR(model.cursor().state().time, next.slowest, 1e-9);
  EXPECT_EQ(window.part<ProgramPanel>().view().current_line(), model.cursor().state().line);
  const ViewRange& range = window.part<ChartsPanel>().range();
  EXPECT_LE(range.lower(), next.from);
  EXPECT_GE(range.upper(), next.to);
  EXPECT_LT(range.upper() - range.lower(), duration());
}

TEST_F(MainWindowTest, NextContourErrorBringsItsPanelUpAndMovesCursorChartsAndView) {
  model.cursor().set_time(0);
  window.activateWindow();
  QTest::keyClick(&window, Qt::Key_F6);
  ASSERT_TRUE(QTest::qWaitFor([this] { return model.cursor().state().time > 0; }, patience));
  EXPECT_TRUE(window.part<ContourView>().isVisible());
  const ContourPlacesModel& places = window.part<ContourView>().places();
  const ContourPlace& next = places.finding(places.next_row(0, true)).place;
  EXPECT_NEAR(model.cursor().state().time, next.time, 1e-9);
  EXPECT_EQ(window.part<ProgramPanel>().view().current_line(), model.cursor().state().line);
  const ViewRange& range = window.part<ChartsPanel>().range();
  EXPECT_LT(range.upper() - range.lower(), duration());
  const CameraState camera = window.scene().scene().camera();
  EXPECT_LT((camera.focal - next.position).norm(), 30 * next.error);
  EXPECT_LT(camera.height, 200 * next.error);
}

TEST_F(MainWindowTest, NextMessageGoesToItsPlace) {
  open("G21 G90 F1000\nG1 X5\nG1 Xabc\nX7\n");
  window.activateWindow();
  QTest::keyClick(&window, Qt::Key_F8);
  EXPECT_EQ(window.part<ProgramPanel>().view().caret().line, 3U);
  EXPECT_EQ(model.cursor().state().line, 4U) << "line 3 does not move";
}

TEST_F(MainWindowTest, AnUnreadableFileIsToldAndTheWindowIsEmpty) {
  model.open("no/such/part.nc");
  wait_until_idle();
  const DiagnosticsModel& list = window.part<DiagnosticsView>().model();
  ASSERT_EQ(list.rowCount(), 1);
  EXPECT_THAT(list.index(0, DiagnosticsModel::message).data().toString().toStdString(),
              testing::HasSubstr("part.nc"));
  EXPECT_EQ(window.part<ProgramPanel>().view().text().line_count(), 0U);
  EXPECT_FALSE(window.part<ChartsPanel>().chart(0).cursor().has_value());
}

TEST_F(MainWindowTest, ADroppedFileIsOpened) {
  const QString file = QString::fromStdString(FEEDSCOPE_SOURCE_DIR "/resources/programs/essid_table1.nc");
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter({600, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(600, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &drop);
  wait_until_idle();
  EXPECT_NEAR(duration(), 1.24, 0.02);
}

TEST_F(MainWindowTest, EverythingStandsWithinTheDefaultWindow) {
  emit window.part<SetupView>().attention_wanted();
  QTest::qWait(50);  // for the layout of what came to the front
  const QRect inside = window.rect();
  for (QWidget* view : std::initializer_list<QWidget*>{&window.part<ProgramPanel>().view(), &window.scene(),
                                                       &window.part<ChartsPanel>(), &window.part<SetupView>(),
                                                       &window.part<PlaybackBar>()}) {
    const QRect place(view->mapTo(&window, QPoint()), view->size());
    EXPECT_TRUE(inside.contains(place)) << view->metaObject()->className();
    EXPECT_GE(place.height(), view->minimumSizeHint().height()) << view->metaObject()->className();
    EXPECT_GE(place.width(), view->minimumSizeHint().width()) << view->metaObject()->className();
  }
  EXPECT_EQ(window.size(), QSize(1280, 800)) << "the contents need more than the default size";
}

TEST_F(MainWindowTest, NoTwoCommandsShareKeys) {
  std::map<QKeySequence, QString> taken;
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    for (const QKeySequence& key : listed.action->shortcuts()) {
      const auto [at, fresh] = taken.emplace(key, listed.action->text());
      EXPECT_TRUE(fresh) << key.toString().toStdString() << ": " << at->second.toStdString() << " and "
                         << listed.action->text().toStdString();
    }
  }
  EXPECT_GT(taken.size(), 30U);
}

void add_long_menus(const QMenu& menu, const QString& path, QStringList& long_menus) {
  constexpr int most = 12;
  int entries = 0;
  for (const QAction* action : menu.actions()) {
    entries += action->isSeparator() ? 0 : 1;
    if (action->menu() != nullptr) {
      add_long_menus(*action->menu(), path + QStringLiteral(" > ") + action->text(), long_menus);
    }
  }
  if (entries > most) {
    long_menus.append(QStringLiteral("%1: %2").arg(path).arg(entries));
  }
}

TEST_F(MainWindowTest, NoMenuHasMoreThanTwelveEntries) {
  QStringList long_menus;
  for (const QAction* menu : window.menuBar()->actions()) {
    add_long_menus(*menu->menu(), menu->text(), long_menus);
  }
  EXPECT_EQ(long_menus.join(QStringLiteral("; ")).toStdString(), "");
}

TEST_F(MainWindowTest, EveryLessonIsInTheMenuWhileAProgramIsOpen) {
  QStringList listed;
  for (const QAction* menu : window.menuBar()->actions()) {
    for (const QAction* list : menu->menu()->actions()) {
      if (list->text().contains(QStringLiteral("wo days"))) {
        for (const QAction* lesson : list->menu()->actions()) {
          listed.append(lesson->text());
        }
      }
    }
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "resources" / "lessons")) {
    files += entry.path().extension() == ".toml" ? 1 : 0;
  }
  EXPECT_EQ(static_cast<std::size_t>(listed.size()), files);
}

TEST_F(MainWindowTest, AJumpToAPlaceMovesTheViewAndTheViewBeforeComesBack) {
  const CameraState before = window.scene().scene().camera();
  model.show_place(duration() / 2, duration() / 2, duration() / 2 + 0.01);
  EXPECT_NE(window.scene().scene().camera(), before);
  for (QAction* action : window.findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(Qt::ALT | Qt::Key_Left)) {
      action->trigger();
    }
  }
  EXPECT_EQ(window.scene().scene().camera(), before);
}

TEST_F(MainWindowTest, ThePathHasAThirdOfTheDefaultWindow) {
  const QWidget& canvas = window.scene().canvas();
  const double share = static_cast<double>(canvas.width()) * canvas.height() / (1280.0 * 800.0);
  EXPECT_GE(share, 0.35) << canvas.width() << "x" << canvas.height();
}

TEST_F(MainWindowTest, EveryCommandSaysWhatItDoes) {
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    // A thing in a list that is switched on, as a panel or a run, is its name; what is off now may say why
    // not.
    EXPECT_TRUE(test::has_own_tip(*listed.action) || listed.action->isCheckable() ||
                !listed.action->isEnabled())
        << listed.action->text().toStdString();
  }
}

TEST_F(MainWindowTest, DuplicateAndAnotherToleranceShowTwoRunsInChartsAndTable) {
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    if (plain_text(listed.action->text()) == "Duplicate") {
      listed.action->trigger();
    }
  }
  ASSERT_TRUE(model.set_tolerance(0.01));
  wait_until_idle();
  ASSERT_EQ(window.part<RunsView>().results().rowCount(), 2);
  EXPECT_EQ(window.part<RunsView>().results().fastest(), std::vector<std::size_t>{0});
  EXPECT_NE(model.runs().result(1), nullptr);
}

TEST_F(MainWindowTest, PanelsComeBackAsTheyWereWithAnotherProgram) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
  QCoreApplication::setOrganizationName("feedscope_test");
  PanelStates states = panel_states(window);
  states.scene.camera.azimuth = 0.25;
  states.scene.camera.perspective = true;
  states.scene.colouring = Colouring::cause;
  states.charts.hidden = {"vx"};
  states.charts.time = Interval{0.1, 0.2};
  states.program_font_size = 17;
  set_panel_states(window, states);
  EXPECT_TRUE(panel_states(window).charts.time.has_value());
  keep_panel_states(window);

  MainWindow another{model, RenderBackend::software};
  restore_panel_states(another);
  const PanelStates restored = panel_states(another);
  EXPECT_NEAR(restored.scene.camera.azimuth, 0.25, 1e-12);
  EXPECT_TRUE(restored.scene.camera.perspective);
  EXPECT_TRUE(restored.scene.camera.fitted);
  EXPECT_EQ(restored.scene.colouring, Colouring::cause);
  EXPECT_EQ(restored.charts, for_any_run(states.charts));
  EXPECT_EQ(restored.program_font_size, 17);
  QCoreApplication::setOrganizationName({});
}

/// The command of the menus with this text.
QAction* command(const MainWindow& window, const QString& text) {
  for (const ListedAction& listed : window.part<HelpMenu>().commands()) {
    if (plain_text(listed.action->text()) == text) {
      return listed.action;
    }
  }
  return nullptr;
}

/// No place of the window asks for a program that the lesson will open.
TEST_F(MainWindowTest, ALessonSaysThatItsRunComesAfterThePrediction) {
  LessonDesk& desk = window.part<LessonView>().desk();
  QSignalSpy opened(&desk, &LessonDesk::opened);
  desk.open(find_lesson("1"), true);
  ASSERT_TRUE(opened.wait(patience));
  const RunNotice& notice = *window.findChild<RunNotice*>();
  EXPECT_EQ(notice.text(), "The run is shown once a prediction is written in the lesson.");
  constexpr int lines = 3;
  EXPECT_LT(notice.height(), lines * notice.fontMetrics().height()) << "a line with its margins";
  EXPECT_EQ(window.part<ProgramPanel>().view().text_without_program(),
            "The program is shown with the run, after the prediction.");
  desk.predict("1 min");
  wait_until_idle();
  EXPECT_EQ(notice.text(), "");
}

TEST_F(MainWindowTest, ALessonSetsUpTheWindowAndLeadsToItsControl) {
  auto* dock = window.findChild<QDockWidget*>("lesson");
  EXPECT_FALSE(dock->isVisible());
  command(window, "Lessons")->trigger();
  EXPECT_TRUE(dock->isVisible());
  LessonView& lesson = window.part<LessonView>();
  lesson.desk().unlock(true);
  QSignalSpy opened(&lesson.desk(), &LessonDesk::opened);
  lesson.desk().open(find_lesson("2"));
  ASSERT_TRUE(opened.wait(patience));
  QTest::mouseClick(&lesson.set_up_button(), Qt::LeftButton);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !model.busy() && lesson.measured().contains("0.767 s"); }, patience))
      << lesson.measured().toStdString();
  EXPECT_EQ(model.file().filename(), "lesson_lines.nc");
  EXPECT_EQ(model.runs().items().size(), 4U);
  for (const Vec3& end : {Vec3(0, 0, 0), Vec3(100, 0, 0)}) {
    EXPECT_TRUE(scene_canvas()->rect().contains(point_in_scene(end))) << "the path of the lesson is in view";
  }
  EXPECT_EQ(window.scene().state().colouring, Colouring::feed);
  EXPECT_FALSE(window.session().changed()) << "nobody is asked to save what the lesson has made";
  model.runs().duplicate(0);
  EXPECT_TRUE(window.session().changed());
  model.runs().history().undo();

  QTest::mouseClick(lesson.values()[1], Qt::LeftButton);
  wait_until_idle();
  EXPECT_EQ(std::get<double>(model.setup().state().value("X.acceleration")), 2);
  emit lesson.setting_wanted("X.jerk");
  EXPECT_EQ(window.part<SetupView>().axes()->currentIndex().data().toString(), "15");
  emit lesson.setting_wanted("lookahead_blocks");
  EXPECT_EQ(window.part<SetupView>().settings()->currentIndex().data().toString(), "8");
  const QModelIndex place = window.part<SetupView>().settings()->currentIndex();
  emit lesson.setting_wanted("model");
  EXPECT_EQ(window.part<SetupView>().settings()->currentIndex(), place);
}

TEST_F(MainWindowTest, TheWindowKnowsWhatLessonsCallItsColouringsAndViews) {
  for (const std::string& name : lesson_colourings()) {
    EXPECT_NE(std::ranges::find(all_colourings(), name, colouring_key), all_colourings().end()) << name;
  }
  // A lesson begins with one run: there is none to compare it with.
  EXPECT_EQ(lesson_colourings().size(),
            all_colourings().size() - std::ranges::count_if(all_colourings(), needs_reference));
  EXPECT_EQ(lesson_cameras()[static_cast<std::size_t>(StandardView::top)], "top");
  EXPECT_EQ(lesson_cameras()[static_cast<std::size_t>(StandardView::bottom)], "bottom");
  EXPECT_EQ(lesson_cameras()[static_cast<std::size_t>(StandardView::left)], "left");
}

TEST(MainWindow, ClosingWhileBusyIsClean) {
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  window.show();
  model.open(FEEDSCOPE_SOURCE_DIR "/resources/programs/freeform_finish.nc");
  QTest::qWait(50);
  EXPECT_TRUE(model.busy());
  window.close();
}

}  // namespace
}  // namespace feedscope::ui
