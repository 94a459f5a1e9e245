// The window in inches, and made again for other units or another language.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <memory>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/circular/circular_table.h"
#include "ui/circular/circular_view.h"
#include "ui/circular/polar_plot.h"
#include "ui/fields/number_box.h"
#include "ui/language/language.h"
#include "ui/language/shown_numbers.h"
#include "ui/runs/runs_view.h"
#include "ui/study/study_view.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"

namespace feedscope::ui {
namespace {

class WindowUnits : public testing::Test {
 protected:
  WindowUnits() { window->show(); }
  ~WindowUnits() override {
    window.reset();
    use_unit_system(UnitSystem::metric);
  }

  void open(const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "part.nc";
    std::ofstream(file) << text;
    model.open(file);
    settle();
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window->busy(); }, patience));
    QCoreApplication::processEvents();
  }
  void make_again() {
    const MainWindow::Handover before = window->hand_over();
    window = std::make_unique<MainWindow>(model, RenderBackend::software);
    window->take_over(before);
    window->show();
    settle();
  }

  Workbench model{shipped_machines(), make_setup({})};
  std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>(model, RenderBackend::software);
  const QTemporaryDir folder;
};

void add_texts(const QAbstractItemModel& table, QStringList& texts) {
  for (int column = 0; column < table.columnCount(); ++column) {
    texts << table.headerData(column, Qt::Horizontal).toString();
    for (int row = 0; row < table.rowCount(); ++row) {
      texts << table.headerData(row, Qt::Vertical).toString() << table.index(row, column).data().toString();
    }
  }
}

/// What labels, buttons, fields and tables say; not the program itself.
QStringList texts_of(MainWindow& window) {
  QStringList texts;
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    texts << label->text();
  }
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
    texts << button->text();
  }
  for (const NumberBox* box : window.findChildren<NumberBox*>()) {
    texts << box->suffix();
  }
  for (const QAbstractItemView* view : window.findChildren<QAbstractItemView*>()) {
    if (view->model() != nullptr) {
      add_texts(*view->model(), texts);
    }
  }
  for (const KinematicChart* chart : window.findChildren<KinematicChart*>()) {
    texts << chart->spec().unit;
  }
  return texts;
}

TEST_F(WindowUnits, InInchesNoPanelSaysAMetricUnit) {
  use_unit_system(UnitSystem::inch);
  window = std::make_unique<MainWindow>(model, RenderBackend::software);
  window->show();
  open(test::small_program);
  window->part<StudyView>().run();
  settle();
  const QRegularExpression metric(
      QStringLiteral("(^|[\\s\\[/0-9])(mm|µm|m/min|m/s²|m/s³|mm/min)($|[\\s\\].,;])"));
  for (const QString& text : texts_of(*window)) {
    EXPECT_FALSE(text.contains(metric)) << text.toStdString();
  }
}

TEST_F(WindowUnits, AWindowMadeAgainShowsTheSameCircularTest) {
  open(test::small_program);
  auto* view = &window->part<CircularView>();
  view->set_state({.radii = {5, 12.7}, .feeds = {3000}});
  view->run();
  settle();
  const int rows = view->table()->rowCount();
  ASSERT_GE(rows, 2);
  view->list()->selectRow(rows - 1);
  use_unit_system(UnitSystem::inch);
  make_again();
  view = &window->part<CircularView>();
  ASSERT_EQ(view->table()->rowCount(), rows) << "nothing is tested again";
  EXPECT_EQ(view->list()->currentIndex().row(), rows - 1);
  EXPECT_FALSE(view->plot()->tests().empty());
}

TEST_F(WindowUnits, AWindowMadeAgainShowsTheSameRun) {
  open(test::small_program);
  model.runs().duplicate(model.runs().current());
  settle();
  model.cursor().set_time(0.1);
  window->part<ChartsPanel>().show_curve(0, 2, false);
  const auto run = model.shown();
  SceneState scene = window->scene().state();
  scene.colouring = Colouring::cause;
  window->scene().set_state(scene);
  use_unit_system(UnitSystem::inch);
  make_again();
  EXPECT_EQ(model.shown(), run) << "nothing is simulated again";
  EXPECT_EQ(model.runs().items().size(), 2U);
  EXPECT_DOUBLE_EQ(model.cursor().state().time, 0.1);
  EXPECT_FALSE(window->part<ChartsPanel>().chart(0).curve_shown(2));
  EXPECT_EQ(window->scene().state().colouring, Colouring::cause);
  EXPECT_EQ(window->part<ChartsPanel>().chart(0).spec().unit, "in/min");
  EXPECT_TRUE(window->session().changed()) << "two runs that are not saved";
}

TEST_F(WindowUnits, AWindowMadeAgainHasTheOtherLanguage) {
  open(test::small_program);
  install_language("fr");
  make_again();
  EXPECT_THAT(window->part<RunsView>().windowTitle().toStdString() +
                  window->part<HelpMenu>().commands().front().place.toStdString(),
              testing::HasSubstr("Fichier"));
  install_language("en");
  make_again();
  EXPECT_THAT(window->part<HelpMenu>().commands().front().place.toStdString(), testing::HasSubstr("File"));
}

TEST_F(WindowUnits, AWindowMadeAgainWithoutAProgramIsEmpty) {
  make_again();
  EXPECT_EQ(model.program(), nullptr);
  EXPECT_FALSE(window->session().changed());
}

}  // namespace
}  // namespace feedscope::ui
