#include "ui/window/menus/picture_commands.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include "core/base/data_folder.h"
#include "core/base/error.h"
#include "tests/ui/run_fixture.h"
#include "ui/shared/paths.h"
#include "ui/window/dialogs/proposed_file.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

using Part = PictureCommands::Part;

class WindowPicturesTest : public testing::Test {
 protected:
  WindowPicturesTest()
      : model_(shipped_machines(), make_setup({})),
        window_(model_, RenderBackend::software),
        pictures_(window_) {
    window_.resize(1200, 800);
    window_.show();
    model_.show(test::simulate_text(test::small_program));
    QApplication::processEvents();
  }

  QTemporaryDir folder_;
  Workbench model_;
  MainWindow window_;
  PictureCommands pictures_;
};

TEST_F(WindowPicturesTest, EveryDetailIsInAPictureOfAViewThatMoves) {
  pictures_.actions().front()->trigger();
  const QImage rested = QApplication::clipboard()->image();
  window_.scene().scene().set_moving(true);
  pictures_.actions().front()->trigger();
  EXPECT_EQ(QApplication::clipboard()->image(), rested);
}

/// The folder of the samples is that of the installed program, or of its sources.
TEST_F(WindowPicturesTest, NothingIsProposedBesideASample) {
  const std::filesystem::path sample = data_folder() / "resources" / "programs" / "essid_table1.nc";
  const QString proposed = proposed_file(sample, QStringLiteral("3d"), QStringLiteral("png"));
  EXPECT_TRUE(proposed.endsWith(QStringLiteral("/essid_table1-3d.png"))) << proposed.toStdString();
  EXPECT_NE(QFileInfo(proposed).absolutePath(), to_qstring(sample.parent_path()));
  EXPECT_TRUE(QFileInfo(QFileInfo(proposed).absolutePath()).isDir());
  EXPECT_EQ(folder_for_files_of(folder_.filePath("part.nc").toStdString()), folder_.path());
}

TEST_F(WindowPicturesTest, ViewAndChartsAreCopiedWithALineBelowThem) {
  pictures_.actions().front()->trigger();
  const QImage copied = QApplication::clipboard()->image();
  const QSize canvas = window_.scene().canvas().size();
  EXPECT_EQ(copied.width(), canvas.width());
  EXPECT_GT(copied.height(), canvas.height());
  const QImage caption = copied.copy(0, canvas.height(), canvas.width(), copied.height() - canvas.height());
  EXPECT_NE(caption, QImage(caption.size(), caption.format()));
  bool written = false;
  for (int x = 0; x < caption.width(); ++x) {
    written = written || caption.pixel(x, caption.height() / 2) != caption.pixel(0, 0);
  }
  EXPECT_TRUE(written);
  EXPECT_EQ(pictures_.picture(Part::window).size(), window_.size());
}

TEST_F(WindowPicturesTest, TheCubeOfViewsStaysInTheWindow) {
  const QImage copied = pictures_.picture(Part::scene);
  const QImage seen = window_.scene().canvas().grab().toImage();
  const QRect corner(seen.width() - 60, 0, 60, 60);
  EXPECT_NE(copied.copy(corner), seen.copy(corner));
  const QImage cleared = copied.copy(corner);
  const QRgb ground = cleared.pixel(0, 0);
  for (int y = 10; y < 50; ++y) {
    EXPECT_EQ(cleared.pixel(30, y), ground) << y;
  }
}

}  // namespace
}  // namespace feedscope::ui
