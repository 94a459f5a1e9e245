#include "ui/slow_places/slow_places_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

namespace feedscope::ui {
namespace {

SlowPlace place(double slowest, double loss, std::uint32_t line) {
  SlowPlace place;
  place.from = slowest - 0.1;
  place.to = slowest + 0.1;
  place.slowest = slowest;
  place.loss = loss;
  place.feed = 10;
  place.programmed_feed = 50;
  place.line = place.first_line = line;
  place.last_line = line + 1;
  place.cause = {CauseKind::exact_stop, -1};
  return place;
}

std::shared_ptr<const SlowPlaces> three_places() {
  auto places = std::make_shared<SlowPlaces>();
  places->places = {place(1, 0.2, 10), place(2, 0.5, 20), place(3, 0.3, 30)};
  places->count = 7;
  places->loss = 2;
  return places;
}

QString text(const SlowPlacesModel& model, int row, int column) {
  return model.index(row, column).data().toString();
}

TEST(SlowPlacesModel, ListsTheWorstFirst) {
  SlowPlacesModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.set_places(three_places());
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(text(model, 0, SlowPlacesModel::loss), "0.5000");
  EXPECT_EQ(text(model, 0, SlowPlacesModel::share), "25.0");
  EXPECT_EQ(text(model, 0, SlowPlacesModel::lines), "20 – 21");
  EXPECT_EQ(text(model, 0, SlowPlacesModel::feed), "600 of 3000");
  EXPECT_EQ(text(model, 0, SlowPlacesModel::cause), "exact stop");
  EXPECT_EQ(text(model, 2, SlowPlacesModel::loss), "0.2000");
  EXPECT_NEAR(model.listed_loss(), 1, 1e-12);
}

TEST(SlowPlacesModel, ListsAsManyAsAskedFor) {
  SlowPlacesModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.set_places(three_places());
  model.set_most(2);
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_NEAR(model.listed_loss(), 0.8, 1e-12);
  model.set_places(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.next_row(0, true), -1);
}

TEST(SlowPlacesModel, StepsInTheOrderOfTimeAndAroundTheEnds) {
  SlowPlacesModel model;
  model.set_places(three_places());
  const auto next = [&](double time, bool forward) {
    return model.place(model.next_row(time, forward)).slowest;
  };
  EXPECT_EQ(next(0, true), 1);
  EXPECT_EQ(next(1, true), 2);
  EXPECT_EQ(next(2.5, true), 3);
  EXPECT_EQ(next(3, true), 1);
  EXPECT_EQ(next(3, false), 2);
  EXPECT_EQ(next(1, false), 3);
  model.set_most(2);
  EXPECT_EQ(next(0, true), 2) << "what is not listed is passed by";
}

}  // namespace
}  // namespace feedscope::ui
