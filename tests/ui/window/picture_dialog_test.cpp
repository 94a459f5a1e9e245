#include "ui/window/dialogs/picture_dialog.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/window/small_session.h"
#include "ui/fields/whole_number_box.h"
#include "ui/language/language.h"
#include "ui/session/session_file.h"
#include "ui/window/dialogs/language_box.h"
#include "ui/window/dialogs/page_preview.h"

namespace feedscope::ui {
namespace {

class PictureDialogTest : public testing::Test {
 protected:
  PictureDialogTest() {
    QSettings().remove("picture");
    subject_.session = test::small_session(folder_);
    subject_.scene = {640, 480};
    subject_.charts = {700, 300};
    subject_.window = {1000, 700};
  }
  ~PictureDialogTest() override { QSettings().remove("picture"); }

  static bool rests(PictureDialog& dialog) {
    return QTest::qWaitFor([&] { return !dialog.busy(); }, patience);
  }
  QByteArray contents(const QString& name) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }
  static PictureWish wish(const char* view, const char* format, const char* size) {
    PictureWish wish;
    wish.view = QString::fromLatin1(view);
    wish.format = QString::fromLatin1(format);
    wish.size = QString::fromLatin1(size);
    return wish;
  }

  QTemporaryDir folder_;
  PictureDialog::Subject subject_;
};

TEST_F(PictureDialogTest, AsksForTheLanguage) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  auto* const language = dialog.findChild<LanguageBox*>();
  EXPECT_EQ(dialog.wish().language, chosen_language()) << "as the window";
  language->choose("fr");
  EXPECT_EQ(dialog.wish().language, "fr");
  language->choose("xx");
  EXPECT_EQ(dialog.wish().language, "fr") << "which is not offered";
  EXPECT_TRUE(dialog.busy()) << "the preview follows";
}

TEST_F(PictureDialogTest, BeginsWithTheSizeOfTheView) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_EQ(dialog.wish().size, QStringLiteral("640x480"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_EQ(dialog.preview().count(), 1);
  EXPECT_TRUE(dialog.state().contains(QStringLiteral("640"))) << dialog.state().toStdString();
  dialog.choose(wish("charts", "png", "1280x960"));
  EXPECT_EQ(dialog.wish().size, QStringLiteral("700x300"));
  EXPECT_TRUE(dialog.busy()) << "another preview";
  ASSERT_TRUE(rests(dialog));
  EXPECT_TRUE(dialog.state().contains(QStringLiteral("700"))) << dialog.state().toStdString();
}

TEST_F(PictureDialogTest, TextIsAsLargeAsInTheViewUntilSomethingElseIsChosen) {
  subject_.text_scale = 1.5;
  const PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_DOUBLE_EQ(dialog.wish().scale, 1.5);
  QSettings().setValue("picture/scale", 2.0);
  const PictureDialog next(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_DOUBLE_EQ(next.wish().scale, 2);
}

TEST_F(PictureDialogTest, SavesWhatTheCommandLineDraws) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  PictureWish dark = wish("3d", "png", "800x500");
  dark.theme = QStringLiteral("dark");
  dark.scale = 2;
  dark.language = QStringLiteral("fr");
  dialog.choose(dark);
  EXPECT_EQ(dialog.wish(), dark);
  QSignalSpy saved(&dialog, &PictureDialog::saved);
  dialog.save(folder_.filePath("p.png"));
  ASSERT_TRUE(rests(dialog));
  ASSERT_EQ(saved.size(), 1) << dialog.state().toStdString();
  write_session(subject_.session, folder_.filePath("s.feedscope").toStdString());
  QProcess again;
  again.setWorkingDirectory(folder_.path());
  again.start(FEEDSCOPE_EXECUTABLE, {"render", "s.feedscope", "--size", "800x500", "--theme", "dark",
                                     "--scale", "2", "--language", "fr", "--out", "again.png"});
  ASSERT_TRUE(again.waitForFinished(patience));
  EXPECT_TRUE(contents("p.png") == contents("again.png"));
  EXPECT_EQ(QImage(folder_.filePath("p.png")).size(), QSize(800, 500));
}

TEST_F(PictureDialogTest, PaperHasItsDots) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  PictureWish sheet = wish("sheet", "png", "A5");
  sheet.dpi = 60;
  sheet.scale = 0.7;
  dialog.choose(sheet);
  dialog.save(folder_.filePath("sheet.png"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_EQ(QImage(folder_.filePath("sheet.png")).size(), QSize(496, 350)) << "210 x 148 mm";
  for (const char* format : {"svg", "pdf"}) {
    dialog.choose(wish("3d", format, "A4"));
    const QString file = QStringLiteral("p.") + format;
    dialog.save(folder_.filePath(file));
    ASSERT_TRUE(rests(dialog));
    EXPECT_TRUE(contents(file).left(200).contains(format == std::string("svg") ? "<svg" : "%PDF"));
  }
}

TEST_F(PictureDialogTest, SaysWhatIsWrongWithASize) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.choose(wish("3d", "png", "wide"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_TRUE(dialog.state().contains(QStringLiteral("wide"))) << dialog.state().toStdString();
  QSignalSpy saved(&dialog, &PictureDialog::saved);
  dialog.save(folder_.filePath("p.png"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_EQ(saved.size(), 0);
  EXPECT_FALSE(QFile::exists(folder_.filePath("p.png")));
}

TEST_F(PictureDialogTest, RemembersWhatWasChosenButNotTheWindowsSize) {
  {
    PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
    PictureWish asked = wish("charts", "pdf", "A3");
    asked.dpi = 150;
    asked.transparent = true;
    dialog.choose(asked);
  }
  {
    PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
    EXPECT_EQ(dialog.wish().view, QStringLiteral("charts"));
    EXPECT_EQ(dialog.wish().format, QStringLiteral("pdf"));
    EXPECT_EQ(dialog.wish().size, QStringLiteral("A3"));
    EXPECT_EQ(dialog.wish().dpi, 150);
    EXPECT_TRUE(dialog.wish().transparent);
    dialog.choose(wish("charts", "png", "700x300"));
  }
  subject_.charts = {900, 444};
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_EQ(dialog.wish().size, QStringLiteral("900x444"));
}

TEST_F(PictureDialogTest, TakesNoFileThatIsThere) {
  PictureDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_TRUE(dialog.proposed_file().endsWith(QStringLiteral("part-3d.png")));
  QFile taken(folder_.filePath("part-3d.png"));
  ASSERT_TRUE(taken.open(QIODevice::WriteOnly));
  EXPECT_TRUE(dialog.proposed_file().endsWith(QStringLiteral("part-3d-2.png")));
}

TEST(PictureWish, BecomesTheArgumentsOfTheCommand) {
  PictureWish wish;
  EXPECT_EQ(picture_arguments(wish, "s"),
            (QStringList{"s", "--view=3d", "--format=png", "--size=1280x960", "--scale=1"}));
  wish.size = QStringLiteral("A4-portrait");
  wish.view = QStringLiteral("window");
  wish.transparent = true;
  wish.theme = QStringLiteral("dark");
  EXPECT_EQ(picture_arguments(wish, "s"),
            (QStringList{"s", "--view=window", "--format=png", "--size=A4-portrait", "--dpi=300", "--scale=1",
                         "--theme=dark"}))
      << "a window has a background";
  wish.format = QStringLiteral("svg");
  wish.size = QStringLiteral("800x600");
  EXPECT_TRUE(wish.has_dpi());
  EXPECT_FALSE(for_preview(wish, 96).has_dpi());
  wish.language = QStringLiteral("fr");
  EXPECT_TRUE(picture_arguments(wish, "s").contains("--language=fr"));
  wish.view = QStringLiteral("sheet");
  EXPECT_TRUE(picture_arguments(wish, "s").contains("--language=fr"));
}

}  // namespace
}  // namespace feedscope::ui
