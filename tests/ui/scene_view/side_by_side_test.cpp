#include "ui/scene_view/side_by_side.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QToolBar>
#include <QToolTip>
#include <algorithm>
#include <map>

#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/program_text/program_panel.h"
#include "ui/scene_view/split_overlay.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/action_table.h"
#include "ui/window/panels/status_panel.h"

namespace feedscope::ui {
namespace {

class SideBySideTest : public testing::Test {
 protected:
  SideBySideTest() {
    window.resize(1280, 800);
    window.show();
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    model.show(simulate_run(input, make_setup({})));
    SetupState fine = model.runs().items()[0].setup;
    fine.set("contour_tolerance_mm", 0.005);
    model.runs().duplicate_as(0, fine);
    for (const RunItem& item : model.runs().items()) {
      model.runs().set_result(item.id, make_shown(simulate_run(input, item.setup.setup())));
    }
    model.runs().select(0);
    model.runs().select(1);
    views.panel_actions()[0]->trigger();
  }

  void wait_for_comparison() {
    while (views.comparison().busy()) {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }
  static void drag(QWidget& widget, const QPoint& place, Qt::MouseButtons buttons) {
    QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, buttons, {});
    QApplication::sendEvent(&widget, &move);
  }

  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  SideBySide& views = window.scenes();
};

TEST_F(SideBySideTest, TheOtherRunIsShownAndFollowsTheChoice) {
  ASSERT_NE(views.second(), nullptr);
  EXPECT_EQ(views.choice()->count(), 1);  // the current run is on the left
  const auto other = model.runs().result(0);
  EXPECT_DOUBLE_EQ(views.second()->scene().duration(), other->run.trajectory->duration());
  model.runs().select(0);
  EXPECT_DOUBLE_EQ(views.second()->scene().duration(), model.runs().result(1)->run.trajectory->duration());
}

TEST_F(SideBySideTest, BothTurnAndColourAlike) {
  window.scene().scene().set_standard_view(StandardView::top);
  window.scene().scene().set_colouring(Colouring::cause);
  EXPECT_EQ(views.second()->state().colouring, Colouring::cause);
  EXPECT_EQ(views.second()->state().camera.elevation, window.scene().state().camera.elevation);
  views.second()->scene().orbit({40, -30});
  views.second()->scene().set_exaggeration(50);
  EXPECT_EQ(window.scene().state().camera.elevation, views.second()->state().camera.elevation);
  EXPECT_EQ(window.scene().state().exaggeration, 50);
}

/// What acts on both views is on the first bar alone, as there is room for one.
TEST_F(SideBySideTest, BothRunsAreNamedAndTheSecondBarHasWhatIsItsOwn) {
  const auto shown_on_bar = [](SceneView& view) {
    QStringList texts;
    for (const QAction* action : view.findChild<QToolBar*>(QStringLiteral("scene_bar"))->actions()) {
      texts.append(plain_text(action->text()));
    }
    texts.removeAll(QString());
    return texts;
  };
  const auto named = [this](const QString& run) {
    QStringList texts;
    for (const QLabel* label : window.scene().findChildren<QLabel*>()) {
      texts.append(label->isVisible() ? label->text() : QString());
    }
    return std::ranges::any_of(texts, [&](const QString& text) { return text.endsWith(' ' + run); });
  };
  EXPECT_TRUE(named(model.runs().lettered_title(1)));
  EXPECT_EQ(views.choice()->currentText(), model.runs().lettered_title(0));
  EXPECT_EQ(shown_on_bar(*views.second()), QStringList({"Measure", "Box"}));
  model.runs().select(0);
  EXPECT_TRUE(named(model.runs().lettered_title(0)));
  const QStringList all = shown_on_bar(window.scene());
  EXPECT_TRUE(all.contains("Fit path")) << all.join(' ').toStdString();
  views.set_mode(ScenesMode::one);
  EXPECT_FALSE(named(model.runs().lettered_title(0)));
  EXPECT_EQ(shown_on_bar(window.scene()), all);
}

TEST_F(SideBySideTest, OneSwitchHidesRapidsInAllViewsAndTheCharts) {
  window.scene().scene().set_rapids_shown(false);
  EXPECT_FALSE(views.second()->scene().rapids_shown());
  EXPECT_FALSE(model.view_range().rapids_shown());
  model.view_range().show_rapids(true);  // as the charts do
  EXPECT_TRUE(window.scene().scene().rapids_shown());
  EXPECT_TRUE(views.second()->scene().rapids_shown());
}

TEST_F(SideBySideTest, APlacePickedOnTheRightIsThatOfTheProgram) {
  const Trajectory& other = *model.runs().result(0)->run.trajectory;
  const double time = other.duration() / 2;
  emit views.second()->picked(time);
  EXPECT_EQ(model.cursor().state().line, other.state(time).line);
}

TEST_F(SideBySideTest, ColoursSayHowEachDiffersFromTheOne) {
  PathScene& left = window.scene().scene();
  left.set_colouring(Colouring::time_lost);
  wait_for_comparison();
  const auto path = views.comparison().samples(1);
  const auto other = views.comparison().samples(0);
  ASSERT_NE(path, nullptr);
  ASSERT_NE(other, nullptr);
  EXPECT_NEAR(double{path->lost.back()}, -double{other->lost.back()}, 1e-6);
  EXPECT_EQ(views.second()->state().colouring, Colouring::time_lost);
  // Chosen: both are compared with it, but not it with itself.
  views.comparison().choose(model.runs().items()[0].id);
  EXPECT_EQ(views.comparison().reference_of(1), 0U);
  EXPECT_EQ(views.comparison().reference_of(0), 1U);
  // With one run alone there is nothing to compare.
  model.runs().remove(0);
  EXPECT_EQ(left.colouring(), Colouring::feed);
}

TEST_F(SideBySideTest, TheMouseTellsBothRuns) {
  views.set_mode(ScenesMode::one);
  PathScene& scene = window.scene().scene();
  scene.set_colouring(Colouring::time_lost);
  wait_for_comparison();
  QApplication::processEvents();
  QWidget& canvas = window.scene().canvas();
  const double time = 0.6 * model.runs().result(1)->run.trajectory->duration();
  const auto told = [&](bool both) {
    const Pixel pixel = scene.pixel_of(scene.drawn_at(time));
    QTest::mouseMove(&canvas, QPoint(5, 5));
    QTest::mouseMove(&canvas, QPointF(pixel[0], pixel[1]).toPoint());
    const auto arrived = [both] {
      const QString text = QToolTip::text();
      return text.contains(QStringLiteral("Line ")) &&
             text.contains(QStringLiteral("Compared with ")) == both;
    };
    return QTest::qWaitFor(arrived, 3000);
  };
  ASSERT_TRUE(told(true)) << QToolTip::text().toStdString();
  const QString text = QToolTip::text();
  EXPECT_TRUE(text.contains(model.runs().lettered_title(0))) << text.toStdString();
  for (const QString& part : {QStringLiteral("ms/mm"), QStringLiteral("since the start"),
                              QStringLiteral("by the other run after"), QStringLiteral("µm apart")}) {
    EXPECT_TRUE(text.contains(part)) << text.toStdString();
  }
  scene.set_colouring(Colouring::feed);
  EXPECT_TRUE(told(false)) << "nothing is compared: " << QToolTip::text().toStdString();
}

TEST_F(SideBySideTest, WithOneRunTheComparingColoursSayWhatToDo) {
  const auto option = [&](const QString& text) -> QAction* {
    for (QAction* action : window.scene().panel_actions()) {
      if (action->text() == text) {
        return action;
      }
    }
    return nullptr;
  };
  QAction* lost = option(QStringLiteral("Time lost or gained"));
  ASSERT_NE(lost, nullptr);
  EXPECT_TRUE(lost->isEnabled());
  lost->trigger();
  EXPECT_EQ(window.scene().scene().colouring(), Colouring::time_lost);
  model.runs().remove(1);
  EXPECT_FALSE(lost->isEnabled());
  EXPECT_TRUE(lost->toolTip().contains(QStringLiteral("Ctrl+D")));
}

TEST_F(SideBySideTest, TheSplitIsDraggedAndMovedByKeys) {
  views.set_mode(ScenesMode::split);
  ASSERT_NE(views.split(), nullptr);
  EXPECT_FALSE(views.panel_actions()[0]->isChecked());
  EXPECT_TRUE(views.panel_actions()[1]->isChecked());
  QApplication::processEvents();
  SplitHandle& handle = views.split()->handle();
  const double width = window.scene().canvas().width();
  const QPoint middle = handle.rect().center();
  QTest::mousePress(&handle, Qt::LeftButton, {}, middle);
  drag(handle, middle + QPoint(-100, 30), Qt::LeftButton);
  QTest::mouseRelease(&handle, Qt::LeftButton, {}, handle.rect().center());
  EXPECT_NEAR(views.split()->share(), 0.5 - 100 / width, 2 / width);
  EXPECT_NEAR(handle.geometry().center().x(), width / 2 - 100, 2);
  drag(handle, middle + QPoint(50, 0), Qt::NoButton);  // no button is down
  EXPECT_NEAR(views.split()->share(), 0.5 - 100 / width, 2 / width);
  const double before = views.split()->share();
  QTest::keyClick(&handle, Qt::Key_Right);
  EXPECT_GT(views.split()->share(), before);
  views.panel_actions()[2]->trigger();
  EXPECT_NEAR(views.split()->share(), before, 1e-12);
  QTest::keyClick(&handle, Qt::Key_End);
  EXPECT_EQ(views.split()->share(), 1);
  QTest::keyClick(&handle, Qt::Key_Home);
  EXPECT_EQ(views.split()->share(), 0);
  EXPECT_EQ(views.state().split, 0);
}

class TwoViewsTest : public SideBySideTest, public testing::WithParamInterface<ScenesMode> {};

/// The camera of both is the same, whatever legends and scales take of the room.
TEST_P(TwoViewsTest, BothShowAPlaceAtTheSamePixel) {
  views.set_mode(ScenesMode::one);
  views.set_mode(GetParam());
  const auto expect_same = [&] {
    for (int i = 0; i < 5; ++i) {
      QApplication::processEvents();
    }
    const QSize first = window.scene().canvas().size();
    const QSize second = views.second()->canvas().size();
    ASSERT_EQ(first.height(), second.height());
    const double aside = (second.width() - first.width()) / 2.0;  // both have their place in the middle
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(40, 15, 0), Vec3(60, 60, 0)}) {
      const Pixel left = window.scene().scene().pixel_of(place);
      const Pixel right = views.second()->scene().pixel_of(place);
      EXPECT_NEAR(left[0] + aside, right[0], 0.01);
      EXPECT_NEAR(left[1], right[1], 0.01);
    }
  };
  expect_same();
  window.resize(1500, 950);
  expect_same();
  window.scene().scene().set_standard_view(StandardView::top);
  expect_same();
  views.second()->scene().orbit({40, -30});
  expect_same();
  views.second()->scene().fit();
  expect_same();
  EXPECT_TRUE(window.scene().state().camera.fitted) << "it goes on to follow the window's size";
  window.scene().scene().set_colouring(Colouring::cause);
  wait_for_comparison();
  expect_same();
}

INSTANTIATE_TEST_SUITE_P(Modes, TwoViewsTest, testing::Values(ScenesMode::side_by_side, ScenesMode::split));

/// A key that two commands have where it is pressed calls neither.
TEST_P(TwoViewsTest, NoKeyIsAmbiguous) {
  views.set_mode(ScenesMode::one);
  views.set_mode(GetParam());
  const auto reaches = [](const QAction& action, const QWidget& focus) {
    if (action.shortcutContext() != Qt::WidgetWithChildrenShortcut) {
      return true;
    }
    for (const QObject* object : action.associatedObjects()) {
      const auto* widget = qobject_cast<const QWidget*>(object);
      if (widget != nullptr && (widget == &focus || widget->isAncestorOf(&focus))) {
        return true;
      }
    }
    return false;
  };
  for (const QWidget* focus : {&window.scene().canvas(), &views.second()->canvas(),
                               static_cast<QWidget*>(&window.part<ChartsPanel>()),
                               static_cast<QWidget*>(&window.part<ProgramPanel>().view())}) {
    std::map<QKeySequence, QString> taken;
    for (const QAction* action : window.findChildren<QAction*>()) {
      for (const QKeySequence& key : action->shortcuts()) {
        if (!key.isEmpty() && !action->associatedObjects().isEmpty() && reaches(*action, *focus)) {
          const auto [at, fresh] = taken.emplace(key, action->text());
          EXPECT_TRUE(fresh) << key.toString().toStdString() << ": " << at->second.toStdString() << " and "
                             << action->text().toStdString();
        }
      }
    }
    EXPECT_GT(taken.size(), 30U);
  }
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  for (QWidget* canvas : {&window.scene().canvas(), &views.second()->canvas()}) {
    canvas->setFocus();
    window.scene().scene().set_standard_view(StandardView::iso);
    QTest::keyClick(canvas, Qt::Key_2, Qt::ControlModifier);
    EXPECT_NEAR(window.scene().state().camera.elevation, 1.5708, 1e-3) << "seen from the top";
    EXPECT_NEAR(views.second()->state().camera.elevation, 1.5708, 1e-3);
    const bool grid = window.scene().state().axes;
    QTest::keyClick(canvas, Qt::Key_G);
    EXPECT_NE(window.scene().state().axes, grid);
    EXPECT_NE(views.second()->state().axes, grid);
  }
}

TEST_F(SideBySideTest, TheSessionKeepsWhatIsCompared) {
  views.set_mode(ScenesMode::split);
  views.split()->set_share(0.25);
  views.comparison().choose(model.runs().items()[0].id);
  const ScenesState state = window.session().capture().scenes;
  EXPECT_EQ(state.mode, ScenesMode::split);
  EXPECT_EQ(state.split, 0.25);
  EXPECT_EQ(state.reference, 0U);
  views.set_state({});
  EXPECT_EQ(views.second(), nullptr);
  EXPECT_EQ(views.comparison().chosen(), 0);
  views.set_state(state);
  EXPECT_EQ(views.state(), state);
  EXPECT_EQ(views.split()->share(), 0.25);
}

/// A second view begins as the first one is, whatever it had to compare with when it came.
TEST_F(SideBySideTest, TheFirstViewStaysAsItIsWhenASecondOneComes) {
  for (const ScenesMode mode : {ScenesMode::side_by_side, ScenesMode::split}) {
    views.set_mode(ScenesMode::one);
    window.scene().scene().set_colouring(Colouring::time_lost);
    wait_for_comparison();
    window.scene().scene().orbit({25, 15});
    const SceneState before = window.scene().state();
    views.set_mode(mode);
    EXPECT_EQ(window.scene().state(), before);
    EXPECT_EQ(views.second()->state().colouring, Colouring::time_lost);
  }
}

TEST_F(SideBySideTest, ProgressPaintsNothingElseAtOnce) {
  struct Paints : QObject {
    int count = 0;
    bool eventFilter(QObject* watched, QEvent* event) override {
      count += event->type() == QEvent::Paint ? 1 : 0;
      return QObject::eventFilter(watched, event);
    }
  } paints;
  QWidget& canvas = window.scene().canvas();
  canvas.installEventFilter(&paints);
  SceneState look = window.scene().state();
  look.colouring = Colouring::time_lost;
  window.scene().set_state(look);
  ASSERT_TRUE(views.comparison().busy());
  emit views.comparison().progressed();
  canvas.update();
  emit model.progressed("Simulating", 0.5);
  EXPECT_EQ(paints.count, 0);
  wait_for_comparison();
  EXPECT_TRUE(QTest::qWaitFor([&] { return paints.count > 0; }));
}

TEST_F(SideBySideTest, EscGivesUpTheComparisonAndTheColoursShowTheFeedAgain) {
  const auto status = [&] {
    const auto* panel = window.findChild<StatusPanel*>();
    const auto* activity = panel->findChild<QLabel*>();
    return activity->isVisible() ? activity->text() : QString();
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy() && !window.busy(); }));
  SceneState look = window.scene().state();
  look.colouring = Colouring::time_lost;
  window.scene().set_state(look);
  ASSERT_TRUE(views.comparison().busy());
  emit views.comparison().progressed();  // as its timer does some times a second
  EXPECT_TRUE(status().startsWith("Comparing runs")) << status().toStdString();
  QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_FALSE(views.comparison().busy());
  EXPECT_EQ(window.scene().scene().colouring(), Colouring::feed);
  EXPECT_EQ(views.second()->scene().colouring(), Colouring::feed);
  EXPECT_EQ(status(), "");
  window.scene().set_state(look);
  wait_for_comparison();
  EXPECT_EQ(status(), "") << "what is idle says nothing of work any more";
  EXPECT_EQ(window.scene().scene().colouring(), Colouring::time_lost);
}

TEST_F(SideBySideTest, OffLeavesOneView) {
  views.panel_actions()[0]->trigger();
  EXPECT_EQ(views.second(), nullptr);
  model.runs().select(0);  // nothing follows any more
  window.scene().scene().fit();
}

}  // namespace
}  // namespace feedscope::ui
