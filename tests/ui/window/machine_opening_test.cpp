#include "ui/window/menus/machine_opening.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>

#include "tests/support/folders.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "ui/messages/diagnostics_view.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

class MachineOpeningTest : public testing::Test {
 protected:
  MachineOpeningTest() {
    window.show();
    model.open(write("part.nc", test::small_program));
    wait_until_idle();
  }

  void wait_until_idle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy(); }, patience));
  }
  std::filesystem::path write(const char* name, const std::string& text) const {
    const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / name;
    std::ofstream(file) << text;
    return file;
  }
  QMessageBox* question() const { return window.findChild<QMessageBox*>(); }
  const Machine& machine() { return model.setup().file().machine; }
  /// All that the list of messages says, a line each.
  std::string messages() const {
    const DiagnosticsModel& list = window.part<DiagnosticsView>().model();
    std::string text;
    for (int row = 0; row < list.rowCount(); ++row) {
      text += list.index(row, DiagnosticsModel::message).data().toString().toStdString() + "\n";
    }
    return text;
  }

  const QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(MachineOpeningTest, OffersTheMachineOfAConfiguration) {
  const auto file =
      write("printer.cfg", "[printer]\nkinematics: corexy\nmax_velocity: 200\nmax_acel: 1000\n");
  window.open(file);
  ASSERT_NE(question(), nullptr);
  EXPECT_THAT(question()->text().toStdString(), testing::HasSubstr("configuration of Klipper"));
  EXPECT_THAT(question()->detailedText().toStdString(), testing::HasSubstr("printer.cfg:4: warning: "));
  EXPECT_NE(machine().id, "printer");
  question()->defaultButton()->click();
  wait_until_idle();
  EXPECT_EQ(machine().id, "printer");
  EXPECT_EQ(model.shown()->run.setup.model->info().id, "klipper");
  EXPECT_THAT(messages(), testing::HasSubstr("max_acel is not used here"));
  EXPECT_THAT(messages(), testing::HasSubstr("Machine imported from printer.cfg"));
  EXPECT_EQ(model.file().filename(), "part.nc") << "the program stays open";
}

TEST_F(MachineOpeningTest, KeepsTheMachineWhenTheOfferIsRefused) {
  const std::string before = machine().id;
  window.open_machine(write("router.txt", "$110=5000\n$111=5000\n$112=500\n"));
  ASSERT_NE(question(), nullptr);
  question()->reject();
  wait_until_idle();
  EXPECT_EQ(machine().id, before);
}

TEST_F(MachineOpeningTest, OpensMachineFilesAndReportsOthers) {
  window.open(FEEDSCOPE_SOURCE_DIR "/machines/huron-kx10.toml");
  wait_until_idle();
  EXPECT_EQ(machine().id, "huron-kx10");
  window.open_machine(write("other.ini", "[Desktop Entry]\nName=x\n"));
  EXPECT_EQ(question(), nullptr);
  EXPECT_THAT(messages(), testing::HasSubstr("other.ini' is not the configuration of a control"));
}

}  // namespace
}  // namespace feedscope::ui
