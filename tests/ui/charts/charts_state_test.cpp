#include "ui/charts/charts_state.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>

#include "tests/ui/charts/charts_panel_fixture.h"

namespace feedscope::ui {
namespace {

class ChartsStateTest : public test::ChartsPanelTest {
 protected:
  /// Everything other than at first.
  ChartsState changed() const {
    ChartsState state;
    state.abscissa = Abscissa::path_length;
    state.time = Interval{0.25, 0.5};
    state.values[1] = Interval{-2, 3};
    state.hidden = {"programmed_feed", "jt"};
    state.shown = {"vx"};
    state.other_runs = {"vz", "ax"};
    state.causes = false;
    state.second_cursor = 0.3;
    return state;
  }
};

/// Over path length the range goes through the place, which costs a few digits.
void expect_same(ChartsState state, const ChartsState& wanted) {
  ASSERT_TRUE(state.time.has_value());
  EXPECT_NEAR(state.time->lower, wanted.time->lower, 1e-6);
  EXPECT_NEAR(state.time->upper, wanted.time->upper, 1e-6);
  state.time = wanted.time;
  EXPECT_EQ(state, wanted);
}

TEST_F(ChartsStateTest, ComesBackAsItWas) {
  panel.set_state(changed());
  expect_same(panel.state(), changed());
  EXPECT_EQ(panel.range().abscissa(), Abscissa::path_length);
  EXPECT_FALSE(panel.chart(0).curve_shown(1));
  EXPECT_TRUE(panel.chart(0).curve_shown(0));
  EXPECT_FALSE(panel.chart(2).curve_shown(0));
  EXPECT_EQ(panel.second_cursor(), 0.3);
  EXPECT_FALSE(panel.causes().isVisibleTo(&panel));
}

TEST_F(ChartsStateTest, TheFirstStateShowsAllAgain) {
  const ChartsState first = panel.state();
  EXPECT_FALSE(first.time.has_value());
  panel.set_state(changed());
  panel.set_state(first);
  EXPECT_EQ(panel.state(), first);
  EXPECT_TRUE(panel.range().shows_all());
}

TEST_F(ChartsStateTest, WithoutARunItAwaitsTheNextOne) {
  ViewRange other_range;
  ChartsPanel another(cursor, other_range);
  another.resize(panel.size());
  another.set_state(changed());
  EXPECT_EQ(another.state(), changed());
  another.set_run(run.trajectory, envelope, true);
  expect_same(another.state(), changed());
  another.set_run(run.trajectory, envelope, false);
  EXPECT_FALSE(another.state().time.has_value()) << "only the first run";
}

TEST_F(ChartsStateTest, RangeBeyondTheRunIsCutToIt) {
  panel.set_state({.time = Interval{-5, 1e9}});
  EXPECT_TRUE(panel.range().shows_all());
  panel.set_state({.second_cursor = 1e9});
  EXPECT_DOUBLE_EQ(*panel.second_cursor(), run.trajectory->duration());
}

TEST_F(ChartsStateTest, AnyRunKeepsWhatBelongsToNone) {
  const ChartsState any = for_any_run(changed());
  EXPECT_EQ(
      any,
      (ChartsState{.abscissa = Abscissa::path_length, .other_runs = changed().other_runs, .causes = false}));
}

TEST_F(ChartsStateTest, JsonComesBackAsItWas) {
  for (const ChartsState& state : {changed(), ChartsState()}) {
    const QByteArray text = QJsonDocument(to_json(state)).toJson();
    ChartsState read = state == changed() ? ChartsState() : changed();
    read_json(QJsonDocument::fromJson(text).object(), read);
    EXPECT_EQ(read, state);
  }
}

TEST_F(ChartsStateTest, WrongJsonChangesNothing) {
  ChartsState wanted = changed();
  wanted.shown.clear();  // older files have no such list
  ChartsState state = wanted;
  read_json({}, state);
  read_json({{"abscissa", 7},
             {"time_s", QJsonArray{3, 1}},
             {"values", QJsonArray{1, 2}},
             {"hidden", "x"},
             {"causes", "no"},
             {"second_cursor_s", "soon"}},
            state);
  EXPECT_EQ(state, wanted);
}

}  // namespace
}  // namespace feedscope::ui
