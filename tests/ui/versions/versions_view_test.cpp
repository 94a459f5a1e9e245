#include "ui/versions/versions_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <fstream>

#include "tests/ui/patience.h"
#include "ui/workbench/workbench.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;

constexpr const char* older_text = "G21 G90 G94 F3000\nG1 X50\nY50\nX0\nM30\n";
constexpr const char* newer_text = "G21 G90 G94 F3000\nG1 X50\nF1000 Y50\nX0\nY90\nM30\n";

class VersionsViewTest : public testing::Test {
 protected:
  VersionsViewTest() {
    QLocale::setDefault(QLocale::c());
    view.resize(700, 300);
    view.show();
    view.follow(bench);
    bench.open(write("new.nc", newer_text));
    EXPECT_TRUE(QTest::qWaitFor([this] { return bench.shown() != nullptr; }, patience));
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / name;
    std::ofstream(file) << text;
    return file;
  }
  void compare_with(const std::filesystem::path& file) {
    view.compare_with(file);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !view.busy(); }, patience));
  }

  QTemporaryDir folder;
  Workbench bench{shipped_machines(), make_setup({})};
  VersionsView view;
};

TEST_F(VersionsViewTest, SaysWhatChangedAndWhatItCosts) {
  compare_with(write("old.nc", older_text));
  const ProgramDifference* difference = view.difference();
  ASSERT_NE(difference, nullptr);
  EXPECT_EQ(difference->of(ProgramChange::added).count, 1U) << "Y90";
  // 50 mm at 1000 instead of 3000 mm/min: 2 s more.
  const auto& slower = difference->of(ProgramChange::feed);
  EXPECT_GT(slower.now.time - slower.old.time, 2.0);
  EXPECT_THAT(view.conclusion().toStdString(), HasSubstr("new.nc instead of old.nc"));
  ASSERT_EQ(view.tree().topLevelItemCount(), 2);
  EXPECT_GE(view.tree().topLevelItem(1)->childCount(), 2);
}

TEST_F(VersionsViewTest, ARowLeadsToItsPlaceInTheProgramThatIsOpen) {
  compare_with(write("old.nc", older_text));
  QSignalSpy places(&view, &VersionsView::place_chosen);
  QTreeWidgetItem* row = view.tree().topLevelItem(1)->child(0);
  QTest::mouseClick(view.tree().viewport(), Qt::LeftButton, {}, view.tree().visualItemRect(row).center());
  ASSERT_EQ(places.count(), 1);
  const double from = places[0][1].toDouble();
  EXPECT_EQ(bench.shown()->run.trajectory->state(from).line,
            row->text(2).section(QChar(0x2013), 0, 0).toUInt());
  EXPECT_GT(places[0][2].toDouble(), from);
}

TEST_F(VersionsViewTest, AnotherRunIsComparedWithTheSameProgram) {
  compare_with(write("old.nc", older_text));
  const double before = view.difference()->of(ProgramChange::none).old.time;
  bench.setup().set("X.velocity", 1.0);
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.shown() != nullptr && !view.busy(); }, patience));
  ASSERT_NE(view.difference(), nullptr);
  EXPECT_GT(view.difference()->of(ProgramChange::none).old.time, before);
}

TEST_F(VersionsViewTest, AFileThatCannotBeReadIsNamed) {
  compare_with(std::filesystem::path(folder.path().toStdString()) / "none.nc");
  EXPECT_EQ(view.difference(), nullptr);
  EXPECT_THAT(view.conclusion().toStdString(), HasSubstr("none.nc"));
}

}  // namespace
}  // namespace feedscope::ui
