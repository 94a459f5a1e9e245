#include "ui/window/picture_commands.h"

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
#include "ui/window/main_window.h"
#include "ui/window/proposed_file.h"

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

  QByteArray saved(Part part, const QString& name) const {
    const QString file = folder_.filePath(name);
    pictures_.save(part, file);
    QFile input(file);
    EXPECT_TRUE(input.open(QIODevice::ReadOnly));
    return input.readAll();
  }

  QTemporaryDir folder_;
  Workbench model_;
  MainWindow window_;
  PictureCommands pictures_;
};

TEST_F(WindowPicturesTest, EveryPartIsSavedInEveryFormat) {
  for (const Part part : {Part::scene, Part::charts, Part::window}) {
    EXPECT_FALSE(QImage::fromData(saved(part, "a.png")).isNull());
    EXPECT_TRUE(QSvgRenderer(saved(part, "a.svg")).isValid());
    EXPECT_TRUE(saved(part, "a.PDF").startsWith("%PDF-"));
  }
  EXPECT_EQ(QImage::fromData(saved(Part::window, "a.png")).size(), window_.size());
  EXPECT_EQ(QImage::fromData(saved(Part::scene, "a.png")).size(), window_.scene().canvas().size());
}

TEST_F(WindowPicturesTest, EveryDetailIsInAPictureOfAViewThatMoves) {
  pictures_.copy_actions().front()->trigger();
  const QImage rested = QApplication::clipboard()->image();
  window_.scene().scene().set_moving(true);
  pictures_.copy_actions().front()->trigger();
  EXPECT_EQ(QApplication::clipboard()->image(), rested);
}

TEST_F(WindowPicturesTest, TheProposedNameIsThatOfTheProgramAndFree) {
  const QString program = folder_.filePath("part.v2.nc");
  QFile file(program);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(test::small_program.c_str());
  file.close();
  model_.open(program.toStdString());
  EXPECT_EQ(pictures_.proposed_file(Part::scene), folder_.filePath("part.v2-3d.png"));
  EXPECT_EQ(pictures_.proposed_file(Part::charts), folder_.filePath("part.v2-charts.png"));
  for (const char* next : {"part.v2-3d-2.png", "part.v2-3d-3.png"}) {
    pictures_.save(Part::scene, pictures_.proposed_file(Part::scene));
    EXPECT_EQ(pictures_.proposed_file(Part::scene), folder_.filePath(next));
  }
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

TEST_F(WindowPicturesTest, APictureIsCopiedToTheClipboard) {
  pictures_.copy_actions().front()->trigger();
  EXPECT_EQ(QApplication::clipboard()->image().size(), window_.scene().canvas().size());
}

TEST_F(WindowPicturesTest, NothingIsLeftWhereAFileCannotBeWritten) {
  EXPECT_THAT([&] { pictures_.save(Part::scene, folder_.filePath("nowhere/a.png")); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("cannot write")));
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

}  // namespace
}  // namespace feedscope::ui
