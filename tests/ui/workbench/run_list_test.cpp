#include "ui/workbench/run_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QPalette>
#include <QSignalSpy>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/cielab.h"
#include "tests/ui/run_fixture.h"
#include "ui/theme/theme.h"
#include "ui/workbench/setup_edit.h"

namespace feedscope::ui {
namespace {

using testing::ElementsAre;

class RunListTest : public testing::Test {
 protected:
  std::vector<int> ids() const {
    std::vector<int> list;
    for (const RunItem& item : runs.items()) {
      list.push_back(item.id);
    }
    return list;
  }
  /// What simulating a row would give.
  void simulate(std::size_t row) {
    const LoadedProgram input =
        load_program(std::make_shared<const SourceText>("test.nc", test::small_program));
    runs.set_result(runs.items()[row].id, make_shown(simulate_run(input, runs.items()[row].setup.setup())));
  }
  SetupState changed(const std::string& key, const SettingValue& value) const {
    SetupState setup = runs.current_item().setup;
    setup.set(key, value);
    return setup;
  }

  RunList runs{make_setup({})};
};

TEST_F(RunListTest, ADuplicateStandsBelowIsCurrentAndHasAColourOfItsOwn) {
  runs.duplicate(0);
  ASSERT_EQ(runs.items().size(), 2U);
  EXPECT_EQ(runs.current(), 1U);
  EXPECT_EQ(runs.items()[1].setup, runs.items()[0].setup);
  EXPECT_NE(runs.items()[1].colour, runs.items()[0].colour);
}

TEST_F(RunListTest, ADuplicateHasTheResultAtOnceUntilItsSetupChanges) {
  simulate(0);
  runs.duplicate(0);
  EXPECT_EQ(runs.result(1), runs.result(0));
  runs.set_setup(1, changed("X.jerk", 3.0), "X.jerk");
  EXPECT_EQ(runs.result(1), nullptr);
  EXPECT_EQ(runs.status(1), RunStatus::waiting);
  EXPECT_NE(runs.result(0), nullptr);
  runs.history().undo();
  EXPECT_EQ(runs.result(1), runs.result(0));
}

TEST_F(RunListTest, ADuplicateWithAnotherSetupHasNoResultOfTheFirst) {
  simulate(0);
  runs.duplicate_as(0, changed("X.jerk", 3.0));
  EXPECT_EQ(runs.result(1), nullptr);
  EXPECT_EQ(runs.status(1), RunStatus::waiting);
}

TEST_F(RunListTest, ARunIsGivenUpUntilItWaitsAgainOrItsSetupChanges) {
  const int id = runs.items()[0].id;
  const QSignalSpy statuses(&runs, &RunList::status_changed);
  runs.give_up(id);
  EXPECT_EQ(runs.status(0), RunStatus::cancelled);
  runs.give_up(id, "no memory");
  EXPECT_EQ(runs.status(0), RunStatus::failed);
  EXPECT_EQ(runs.failure(0), "no memory");
  runs.resume(0);
  EXPECT_EQ(runs.status(0), RunStatus::waiting);
  EXPECT_EQ(statuses.count(), 3);
  runs.give_up(id);
  runs.set_setup(0, changed("X.jerk", 3.0), "X.jerk");
  EXPECT_EQ(runs.status(0), RunStatus::waiting);
  simulate(0);
  runs.give_up(id);
  EXPECT_EQ(runs.status(0), RunStatus::simulated);
}

TEST_F(RunListTest, EveryChangeCanBeUndoneAndRedone) {
  runs.duplicate(0);
  runs.duplicate(1);
  const std::vector<int> three = ids();
  runs.move(2, 0);
  EXPECT_THAT(ids(), ElementsAre(three[2], three[0], three[1]));
  EXPECT_EQ(runs.current(), 0U);  // the current run moves along
  runs.remove(1);
  runs.rename(0, "fine");
  runs.set_visible(0, false);
  runs.set_setup(0, changed("X.jerk", 3.0), "X.jerk");
  const std::vector<RunItem> last = runs.items();
  while (runs.history().canUndo()) {
    runs.history().undo();
  }
  EXPECT_THAT(ids(), ElementsAre(three[0]));
  EXPECT_TRUE(runs.items()[0].visible);
  while (runs.history().canRedo()) {
    runs.history().redo();
  }
  EXPECT_EQ(runs.items(), last);
}

TEST_F(RunListTest, UndoOfAnEditGoesToTheRunThatWasEdited) {
  runs.set_setup(0, changed("X.jerk", 3.0), "X.jerk");
  runs.duplicate(0);
  runs.history().undo();
  runs.history().undo();
  EXPECT_EQ(runs.current(), 0U);
  EXPECT_FALSE(runs.items()[0].setup.edited("X.jerk"));
}

TEST_F(RunListTest, TheLastRunStays) {
  runs.remove(0);
  EXPECT_EQ(runs.items().size(), 1U);
  EXPECT_FALSE(runs.history().canUndo());
}

TEST_F(RunListTest, AChangeThatChangesNothingIsNoStepOfTheHistory) {
  runs.set_setup(0, runs.items()[0].setup, "nothing");
  runs.set_visible(0, true);
  runs.move(0, 5);
  EXPECT_EQ(runs.history().count(), 0);
}

TEST_F(RunListTest, SaysWhatChangedAndNothingElse) {
  runs.duplicate(0);
  runs.rename(1, "fine");  // so that no title depends on another run
  const QSignalSpy list(&runs, &RunList::list_changed);
  const QSignalSpy items(&runs, &RunList::item_changed);
  const QSignalSpy setups(&runs, &RunList::setup_changed);
  runs.rename(0, "coarse");
  EXPECT_EQ(items.count(), 1);
  EXPECT_EQ(setups.count(), 0);
  runs.set_setup(1, changed("X.jerk", 3.0), "X.jerk");
  EXPECT_EQ(items.count(), 2);
  EXPECT_EQ(setups.count(), 1);
  EXPECT_EQ(list.count(), 0);
}

TEST_F(RunListTest, AResultOfARunThatIsGoneIsDropped) {
  runs.duplicate(0);
  const int gone = runs.items()[1].id;
  runs.remove(1);
  runs.set_result(gone, std::make_shared<const ShownRun>());
  EXPECT_EQ(runs.result(0), nullptr);
}

TEST_F(RunListTest, ATitleSaysModelToleranceAndWhatIsChanged) {
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.1 mm");
  SetupState setup = changed("X.jerk", 3.0);
  setup.set("contour_tolerance_mm", 0.05);
  runs.set_setup(0, setup, "two");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.05 mm, X Jerk 3 m/s³");
  for (const char* key : {"X.velocity", "Y.velocity", "Z.velocity"}) {
    setup.set(key, 7.0);
  }
  runs.set_setup(0, setup, "more");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(),
            "essid, 0.05 mm, X Jerk 3 m/s³, X Y Z Velocity 7 m/min");
  setup.set("Y.jerk", 4.0);
  setup.set("X.acceleration", 0.5);
  runs.set_setup(0, setup, "still more");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(),
            "essid, 0.05 mm, X Acceleration 0.5 m/s², X Y Jerk 3 / 4 m/s³, 1 more");
  runs.rename(0, "mine");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "mine");
}

TEST_F(RunListTest, ATitleGivesRotaryAxesTheirOwnUnit) {
  RunList five(make_setup({"five-axis-table-ac", "essid", {}, {}}));
  SetupState setup = five.current_item().setup;
  for (const char* key : {"A.velocity", "X.velocity", "Y.velocity"}) {
    setup.set(key, 7.0);
  }
  five.set_setup(0, setup, "slower");
  EXPECT_TRUE(
      five.title(five.items()[0]).endsWith(QStringLiteral("A Velocity 7 rev/min, X Y Velocity 7 m/min")))
      << five.title(five.items()[0]).toStdString();
}

TEST_F(RunListTest, ATitleSaysTheToleranceOfTheProgramWhereThatIsInForce) {
  QSignalSpy renamed(&runs, &RunList::item_changed);
  PathControl fine;
  fine.contour_tolerance = 0.02;
  runs.set_feed_controls({fine});
  EXPECT_EQ(renamed.count(), 1);
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.02 mm");
  runs.set_feed_controls({fine, PathControl()});
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.02 … 0.1 mm");
  runs.set_setup(0, changed("program_tolerance", std::string("off")), "off");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.1 mm");
}

TEST_F(RunListTest, TitlesTellRunsApart) {
  runs.duplicate(0);
  runs.duplicate(0);
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "essid, 0.1 mm");
  EXPECT_EQ(runs.title(runs.items()[1]).toStdString(), "essid, 0.1 mm (2)");
  EXPECT_EQ(runs.title(runs.items()[2]).toStdString(), "essid, 0.1 mm (3)");
  QSignalSpy renamed(&runs, &RunList::item_changed);
  runs.rename(0, "mine");
  EXPECT_EQ(renamed.count(), 3) << "those behind are told that their titles changed";
  EXPECT_EQ(runs.title(runs.items()[1]).toStdString(), "essid, 0.1 mm");
  EXPECT_EQ(runs.title(runs.items()[2]).toStdString(), "essid, 0.1 mm (2)");
  runs.set_setup(1, SetupState(make_setup({"huron-kx10", "essid", 0.1, {}})), "machine");
  EXPECT_EQ(runs.title(runs.items()[0]).toStdString(), "mine");
  EXPECT_EQ(runs.title(runs.items()[1]).toStdString(), "huron-kx10, essid, 0.1 mm");
  EXPECT_EQ(runs.title(runs.items()[2]).toStdString(), "spinner-mvc850, essid, 0.1 mm");
  runs.history().undo();
  EXPECT_EQ(runs.title(runs.items()[2]).toStdString(), "essid, 0.1 mm (2)");
}

TEST_F(RunListTest, ATitleMayLeaveOutWhatIsStudied) {
  SetupState setup = changed("X.jerk", 3.0);
  setup.set("lookahead_blocks", 3.0);
  runs.set_setup(0, setup, "two");
  const auto title = [&](const char* left_out) {
    return run_title(runs.items()[0], {}, left_out).toStdString();
  };
  EXPECT_EQ(title(""), "essid, 0.1 mm, X Jerk 3 m/s³, Look-ahead (blocks) 3");
  EXPECT_EQ(title("contour_tolerance_mm"), "essid, X Jerk 3 m/s³, Look-ahead (blocks) 3");
  EXPECT_EQ(title("X.jerk"), "essid, 0.1 mm, Look-ahead (blocks) 3");
}

/// Of two colours, by WCAG 2.1: from 1 to 21.
double contrast(const QColor& one, const QColor& other) {
  const auto luminance = [](const QColor& colour) {
    const auto light = test::to_linear({colour.redF(), colour.greenF(), colour.blueF()});
    return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2] + 0.05;
  };
  const double a = luminance(one);
  const double b = luminance(other);
  return std::max(a, b) / std::min(a, b);
}

/// In the charts curves of other runs lie among those of the axes.
TEST(RunColour, IsThatOfNoCurveInAnyTheme) {
  const auto lab = [](const QColor& colour) {
    return test::to_lab(test::to_linear({colour.redF(), colour.greenF(), colour.blueF()}));
  };
  const auto distance = [&](const QColor& one, const QColor& other) {
    const auto a = lab(one);
    const auto b = lab(other);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  constexpr double told_apart = 18;  // [CIELAB]
  for (std::size_t run = 0; run < 8; ++run) {
    for (const QColor& window : {QColor(Qt::white), QColor(Qt::black)}) {
      const QPalette palette(window);
      const ThemeColours& theme = theme_colours(palette);
      EXPECT_GE(contrast(run_colour(run), theme.plot), 3) << "run " << run + 1;  // WCAG 2.1, 1.4.11
      for (const QColor& curve :
           {theme.axes[0], theme.axes[1], theme.axes[2], theme.path, theme.programmed}) {
        EXPECT_GT(distance(run_colour(run), curve), told_apart)
            << "run " << run + 1 << ", " << curve.name().toStdString();
      }
    }
    for (std::size_t other = 0; other < run; ++other) {
      EXPECT_GT(distance(run_colour(run), run_colour(other)), told_apart) << run + 1 << " and " << other + 1;
    }
  }
}

/// In grey print the dashes tell them apart: colours that are seen on light and dark grounds are all about as
/// light.
TEST(RunColour, EightRunsAreToldApartWithEveryKindOfColourVisionAndInGrey) {
  const auto lab = [](std::size_t run, const test::ColourVision& vision) {
    const QColor colour = run_colour(run);
    return test::seen_lab({colour.redF(), colour.greenF(), colour.blueF()}, vision);
  };
  for (std::size_t run = 0; run < 8; ++run) {
    for (std::size_t other = 0; other < run; ++other) {
      for (const test::ColourVision& vision : test::colour_visions) {
        const double least = run < 5 ? 25 : 15;  // [CIELAB]
        EXPECT_GT(test::lab_distance(lab(run, vision), lab(other, vision)), least) << run << " and " << other;
      }
      EXPECT_NE(run_dashes(run), run_dashes(other));
    }
  }
}

/// Two runs that differ in tolerance, and one of another model.
class ComparedSetupsTest : public RunListTest {
 protected:
  ComparedSetupsTest() {
    SetupState fine = runs.items()[0].setup;
    fine.set_tolerance(0.02);
    runs.duplicate_as(0, fine);
    SetupState other = runs.items()[0].setup;
    other.set_model(find_model("cam"));
    runs.duplicate_as(1, other);
    runs.select(0);
  }
  const SetupState& setup(std::size_t row) const { return runs.items()[row].setup; }
  SetupEdit edit{runs};
};

TEST_F(ComparedSetupsTest, AChangeIsOneOfEveryRunThatKnowsTheKeyInOneStep) {
  edit.set("alpha", 2.0);
  EXPECT_TRUE(setup(0).edited("alpha"));
  EXPECT_TRUE(setup(1).edited("alpha"));
  EXPECT_FALSE(setup(2).edited("alpha")) << "cam knows no alpha";
  edit.set("X.jerk", 7.0);
  EXPECT_TRUE(setup(2).edited("X.jerk"));
  runs.history().undo();
  runs.history().undo();
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_FALSE(setup(row).edited("alpha")) << "one step each";
    EXPECT_FALSE(setup(row).edited("X.jerk"));
  }
  EXPECT_THROW(edit.set("alpha", -1e9), InputError);
  EXPECT_FALSE(setup(1).edited("alpha")) << "what is refused changes no run";
}

TEST_F(ComparedSetupsTest, WhatIsComparedIsOfOneRun) {
  edit.set_tolerance(0.05);
  EXPECT_EQ(std::get<double>(setup(1).value("contour_tolerance_mm")), 0.02);
  EXPECT_EQ(std::get<double>(setup(0).value("contour_tolerance_mm")), 0.05);
  edit.set_model(find_model("gassara"));
  EXPECT_EQ(setup(1).file().model->info().id, "essid") << "models are compared";
}

TEST_F(ComparedSetupsTest, AnotherMachineIsOneOfAllRunsWhichStayApart) {
  edit.set("alpha", 2.0);
  edit.set_file(make_setup({"huron-kx10", {}, {}, {}}));
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(setup(row).file().machine.id, "huron-kx10") << row;
    EXPECT_FALSE(setup(row).edited("alpha")) << row;
  }
  EXPECT_EQ(std::get<double>(setup(1).value("contour_tolerance_mm")), 0.02);
  EXPECT_EQ(setup(2).file().model->info().id, "cam");
}

TEST_F(ComparedSetupsTest, ACopyIsThereToBeChanged) {
  runs.duplicate(0);
  edit.set("alpha", 2.0);
  EXPECT_TRUE(setup(1).edited("alpha"));
  EXPECT_FALSE(setup(0).edited("alpha"));
}

TEST_F(ComparedSetupsTest, ACopyWithAnotherJerkOfXIsComparedInTheJerkOfAllAxes) {
  runs.duplicate(0);
  for (const char* key : {"X.jerk", "Y.jerk", "Z.jerk"}) {
    edit.set(key, 7.0);
    EXPECT_TRUE(setup(1).edited(key));
    EXPECT_FALSE(setup(0).edited(key)) << key;
  }
  edit.set("X.acceleration", 0.5);
  EXPECT_TRUE(setup(0).edited("X.acceleration")) << "no run differs in it";
}

TEST_F(ComparedSetupsTest, OfTheCurrentRunAloneWhereThatIsWanted) {
  edit.set_for_all(false);
  edit.set("X.jerk", 7.0);
  EXPECT_FALSE(setup(1).edited("X.jerk"));
}

TEST_F(ComparedSetupsTest, TheRunThatIsNotChangedIsNamedByWhatTheOthersChange) {
  runs.remove(2);
  runs.remove(1);
  SetupState other = setup(0);
  other.set("X.jerk", 22.5);
  runs.duplicate_as(0, other);
  EXPECT_EQ(short_run_titles(runs.items(), {}), QStringList({"X Jerk 15 m/s³", "X Jerk 22.5 m/s³"}));
}

TEST_F(ComparedSetupsTest, ShortTitlesAreWhatTellsTheRunsApart) {
  runs.remove(2);
  EXPECT_EQ(short_run_titles(runs.items(), {}), QStringList({"0.1 mm", "0.02 mm"}));
  runs.rename(1, "finishing");
  EXPECT_EQ(short_run_titles(runs.items(), {})[1], "finishing");
  EXPECT_EQ(short_run_titles(std::span(runs.items()).first(1), {}),
            QStringList(run_title(runs.items()[0], {})));
}

TEST(RunLetters, GoOnAfterTheAlphabet) {
  EXPECT_EQ(run_letter(0), "A");
  EXPECT_EQ(run_letter(25), "Z");
  EXPECT_EQ(run_letter(26), "A1");
}

}  // namespace
}  // namespace feedscope::ui
