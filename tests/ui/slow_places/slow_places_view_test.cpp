#include "ui/slow_places/slow_places_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include "tests/ui/run_fixture.h"

namespace feedscope::ui {
namespace {

class SlowPlacesViewTest : public testing::Test {
 protected:
  SlowPlacesViewTest() {
    view.resize(600, 200);
    view.show();
    view.set_places(places);
  }
  double last_time() const { return chosen.last()[0].toDouble(); }

  feedscope::Run run = test::simulate_text(test::small_program);
  std::shared_ptr<const SlowPlaces> places =
      std::make_shared<const SlowPlaces>(find_slow_places(*run.trajectory));
  SlowPlacesView view;
  QSignalSpy chosen{&view, &SlowPlacesView::place_chosen};
};

TEST_F(SlowPlacesViewTest, AClickGoesToTheWorstPlace) {
  ASSERT_GE(places->places.size(), 3U);
  const auto worst = std::ranges::max_element(places->places, {}, &SlowPlace::loss);
  const QRect row = view.list().visualRect(view.model().index(0, SlowPlacesModel::lines));
  QTest::mouseClick(view.list().viewport(), Qt::LeftButton, {}, row.center());
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(last_time(), worst->slowest);
  EXPECT_EQ(chosen[0][1].toDouble(), worst->from);
  EXPECT_EQ(chosen[0][2].toDouble(), worst->to);
}

TEST_F(SlowPlacesViewTest, ActionsStepInTheOrderOfTheProgram) {
  QAction& next = *view.panel_actions()[0];
  EXPECT_EQ(next.shortcut(), QKeySequence(Qt::Key_F7));
  view.set_time(places->places[0].slowest);
  for (std::size_t i = 1; i < places->places.size(); ++i) {
    next.trigger();
    EXPECT_EQ(last_time(), places->places[i].slowest);
  }
  next.trigger();
  EXPECT_EQ(last_time(), places->places[0].slowest);
  view.panel_actions()[1]->trigger();
  EXPECT_EQ(last_time(), places->places.back().slowest);
}

TEST_F(SlowPlacesViewTest, SaysWhatIsLostInAll) {
  EXPECT_THAT(view.summary().toStdString(), testing::HasSubstr("lost against the programmed feed"));
  view.set_places(nullptr);
  EXPECT_EQ(view.summary(), "");
  EXPECT_EQ(view.model().rowCount(), 0);
  view.panel_actions()[0]->trigger();
  EXPECT_TRUE(chosen.isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
