// Every panel in a window as large as a screen of 1024x768 at 144 dots an inch.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QScrollArea>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <memory>
#include <vector>

#include "tests/support/folders.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/language/language.h"
#include "ui/scene_view/lens_overlay.h"
#include "ui/scene_view/scene_view.h"
#include "ui/window/main_window.h"
#include "ui/window/panels/status_panel.h"

namespace feedscope::ui {
namespace {

constexpr QSize screen(683, 512);  // [logical pixels]

/// What each part of a window needs, for the message of a failure.
std::string needs(const MainWindow& window) {
  QString text = QStringLiteral("centre %1").arg(window.centralWidget()->minimumSizeHint().width());
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    if (dock->isVisible() && window.rect().contains(dock->geometry().center())) {
      const QSize size = dock->minimumSizeHint();
      text += QStringLiteral(", %1 %2x%3").arg(dock->objectName()).arg(size.width()).arg(size.height());
    }
  }
  return text.toStdString();
}

/// What is wider than its place in `dock` and cannot be scrolled sideways: contents of scroll areas, columns
/// of tables.
std::string cut_in(const QDockWidget& dock) {
  QString text;
  for (const QScrollArea* area : dock.findChildren<QScrollArea*>()) {
    const bool fixed = area->isVisible() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
    if (fixed && area->widget()->minimumSizeHint().width() > area->viewport()->width()) {
      text += QStringLiteral("contents of %1 in %2 ")
                  .arg(area->widget()->minimumSizeHint().width())
                  .arg(area->viewport()->width());
    }
  }
  for (const QTableView* table : dock.findChildren<QTableView*>()) {
    const bool fixed = table->isVisible() && table->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
    if (fixed && table->horizontalHeader()->length() > table->viewport()->width()) {
      text += QStringLiteral("columns of %1 in %2 ")
                  .arg(table->horizontalHeader()->length())
                  .arg(table->viewport()->width());
    }
  }
  return text.toStdString();
}

class SmallScreenTest : public testing::TestWithParam<const char*> {
 protected:
  SmallScreenTest() { install_language(GetParam()); }
  ~SmallScreenTest() override { install_language("en"); }
};

/// The legend, the scales, the cube and the lens of four runs, at the sizes of usual screens.
TEST_P(SmallScreenTest, WhatLiesOverThePathDoesNotCoverEachOther) {
  Workbench model(shipped_machines(), make_setup({}));
  MainWindow window(model, RenderBackend::software);
  window.show();
  model.show(test::simulate_text(test::small_program));
  for (const double tolerance : {0.02, 0.05, 0.1}) {
    model.runs().duplicate(0);
    model.set_tolerance(tolerance);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !model.busy(); }, patience));
  for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)}) {
    window.resize(size);
    for (int i = 0; i < 5; ++i) {
      QApplication::processEvents();  // the lens takes its corner after a frame
    }
    const QWidget& canvas = window.scene().canvas();
    std::vector<QRectF> places;
    for (const auto& [upper, lower] : window.scene().scene().covered()) {
      const double ratio = canvas.devicePixelRatioF();
      places.emplace_back(QPointF(upper[0], upper[1]) / ratio, QPointF(lower[0], lower[1]) / ratio);
    }
    EXPECT_GE(places.size(), 4U) << "legend, colours, scale, cube";
    const auto* lens = window.scene().findChild<LensOverlay*>();
    ASSERT_NE(lens, nullptr);
    EXPECT_TRUE(lens->isVisible()) << size.width();
    const QRectF lens_place(lens->mapTo(&window, QPoint()) - canvas.mapTo(&window, QPoint()), lens->size());
    const auto is_lens = [&](const QRectF& place) {
      return (place.center() - lens_place.center()).manhattanLength() < 2;
    };
    EXPECT_EQ(std::ranges::count_if(places, is_lens), 1) << size.width();
    for (std::size_t a = 0; a < places.size(); ++a) {
      EXPECT_TRUE(QRectF(canvas.rect()).adjusted(-1, -1, 1, 1).contains(places[a])) << size.width();
      for (std::size_t b = 0; b < a; ++b) {
        const QRectF both = places[a] & places[b];
        EXPECT_FALSE(both.width() > 1 && both.height() > 1) << size.width() << ": " << a << " on " << b;
      }
    }
  }
}

TEST_P(SmallScreenTest, EveryPanelFitsIntoTheWindow) {
  Workbench model(shipped_machines(), make_setup({}));
  MainWindow window(model, RenderBackend::software);
  window.resize(screen);
  window.show();
  // Long enough for bands of the usual motion, with the time at each feed beside the charts.
  const auto program = std::make_shared<const SourceText>(
      SourceText::from_file(std::string(FEEDSCOPE_SOURCE_DIR) + "/resources/programs/trochoidal_slot.nc"));
  model.show(simulate_run(load_program(program), make_setup({})));
  const FeedShares& shares = window.part<ChartsPanel>().shares();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shares.is_empty(); }, patience));
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QApplication::processEvents();
    EXPECT_EQ(cut_in(*dock), "") << dock->objectName().toStdString();
    const QSize least = window.layout()->minimumSize();
    EXPECT_LE(least.width(), screen.width()) << dock->objectName().toStdString() << ": " << needs(window);
    EXPECT_LE(least.height(), screen.height()) << dock->objectName().toStdString() << ": " << needs(window);
  }
}

/// The note at the left gives way: its tip has all of it.
TEST_P(SmallScreenTest, TheStatusBarShowsWhatIsAtTheCursorBesideItsNote) {
  Workbench model(shipped_machines(), make_setup({}));
  MainWindow window(model, RenderBackend::software);
  window.show();
  const auto program = std::make_shared<const SourceText>(
      SourceText::from_file(std::string(FEEDSCOPE_SOURCE_DIR) + "/resources/programs/trochoidal_slot.nc"));
  model.show(simulate_run(load_program(program), make_setup({})));
  model.cursor().set_time(100);
  for (const QSize size : {screen, QSize(1024, 768)}) {
    window.resize(size);
    QApplication::processEvents();
    const QStatusBar* bar = window.statusBar();
    const auto* status = bar->findChild<StatusPanel*>();
    EXPECT_GE(status->width(), status->sizeHint().width()) << size.width();
    for (const QLabel* label : bar->findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) {
        continue;
      }
      const QRect place(label->mapTo(bar, QPoint()), label->size());
      EXPECT_TRUE(bar->rect().contains(place)) << label->text().toStdString();
      EXPECT_TRUE(label->width() >= label->sizeHint().width() || label->toolTip() == label->text())
          << label->text().toStdString();
      EXPECT_TRUE(label->width() >= label->sizeHint().width() || size == screen)
          << "1024 pixels are enough for " << label->text().toStdString();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, SmallScreenTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace feedscope::ui
