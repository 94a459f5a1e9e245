#include "ui/window/dialogs/film_dialog.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/window/small_session.h"
#include "ui/fields/number_box.h"
#include "ui/fields/whole_number_box.h"
#include "ui/language/language.h"
#include "ui/session/session_file.h"
#include "ui/window/dialogs/language_box.h"

namespace feedscope::ui {
namespace {

class FilmDialogTest : public testing::Test {
 protected:
  FilmDialogTest() {
    QSettings().remove("film");
    subject_.session = test::small_session(folder_);
    subject_.duration = test::simulate_text(test::small_program).trajectory->duration();
    subject_.shown = {0.5, 1};
    subject_.scene = {641, 481};
  }
  ~FilmDialogTest() override { QSettings().remove("film"); }

  static bool rests(FilmDialog& dialog) {
    return QTest::qWaitFor([&] { return !dialog.busy(); }, patience);
  }
  static FilmWish small_film() {
    FilmWish wish;
    wish.times = {.from = 0.5, .to = 0.9, .speed = 1, .fps = 5};
    wish.size = QStringLiteral("320x240");
    wish.trail = 0.25;
    return wish;
  }
  QStringList pictures() const {
    return QDir(folder_.path())
        .entryList({QStringLiteral("*.png"), QStringLiteral("*.part")},
                   QDir::Files | QDir::Dirs | QDir::Hidden, QDir::Name);
  }
  QByteArray contents(const QString& name) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
  }

  QTemporaryDir folder_;
  FilmDialog::Subject subject_;
};

TEST_F(FilmDialogTest, BeginsWithWhatTheChartsShow) {
  const FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_DOUBLE_EQ(dialog.wish().times.from, 0.5);
  EXPECT_DOUBLE_EQ(dialog.wish().times.to, 1);
  EXPECT_DOUBLE_EQ(dialog.wish().times.speed, usual_film_speed(0.5));
  EXPECT_DOUBLE_EQ(dialog.wish().trail, 2 * dialog.wish().times.speed);
}

TEST_F(FilmDialogTest, OffersTheLanguagesOfPicturesAndBeginsWithThatOfTheWindow) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  auto& box = *dialog.findChild<LanguageBox*>();
  EXPECT_EQ(dialog.wish().language, chosen_language());
  EXPECT_EQ(box.count(), languages().size());
  box.choose(QStringLiteral("fr"));
  EXPECT_EQ(dialog.wish().language, QStringLiteral("fr"));
  FilmWish wish = small_film();
  wish.language = QStringLiteral("en");
  dialog.choose(wish);
  EXPECT_EQ(dialog.wish().language, QStringLiteral("en"));
}

TEST_F(FilmDialogTest, SaysWhileOneTypesHowLongTheFilmWillBe) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.choose(small_film());
  EXPECT_EQ(dialog.length_text(), QStringLiteral("0.600\u00a0s in 3 frames"));
  auto& rate = *dialog.findChild<WholeNumberBox*>();
  rate.selectAll();
  QTest::keyClicks(&rate, "10");
  EXPECT_EQ(dialog.length_text(), QStringLiteral("0.500\u00a0s in 5 frames")) << "before Enter";
  auto* to = dialog.findChildren<NumberBox*>()[1];
  to->selectAll();
  QTest::keyClicks(to, "0.4");
  EXPECT_EQ(dialog.length_text(), QStringLiteral("The film must end after it begins."));
}

TEST_F(FilmDialogTest, OffersNoFilmThatTheCommandWouldRefuse) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  const auto* save = dialog.findChildren<QPushButton*>()[0];
  ASSERT_TRUE(save->text().contains(QStringLiteral("Save"))) << save->text().toStdString();
  EXPECT_TRUE(save->isEnabled());
  FilmWish wish = small_film();
  wish.times.speed = 0.0001;
  wish.times.fps = 120;
  dialog.choose(wish);
  EXPECT_THAT(dialog.length_text().toStdString(), testing::HasSubstr("can be written. The speed must be"));
  EXPECT_FALSE(save->isEnabled());
  wish = small_film();
  wish.size = QStringLiteral("wide");
  dialog.choose(wish);
  EXPECT_THAT(dialog.length_text().toStdString(), testing::HasSubstr("width and a height"));
  EXPECT_FALSE(save->isEnabled());
  dialog.choose(small_film());
  EXPECT_TRUE(save->isEnabled());
}

TEST_F(FilmDialogTest, SavesWhatTheCommandLineFilms) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.choose(small_film());
  QSignalSpy saved(&dialog, &FilmDialog::saved);
  dialog.save(folder_.filePath("a%d.png"));
  EXPECT_TRUE(dialog.busy());
  ASSERT_TRUE(rests(dialog));
  ASSERT_EQ(saved.size(), 1) << dialog.state().toStdString();
  EXPECT_EQ(pictures(), QStringList({"a0.png", "a1.png", "a2.png"}));
  write_session(subject_.session, folder_.filePath("s.feedscope").toStdString());
  QProcess again;
  again.setWorkingDirectory(folder_.path());
  again.start(FEEDSCOPE_EXECUTABLE,
              {"render", "s.feedscope", "--from", "0.5", "--to", "0.9", "--speed", "1", "--fps", "5",
               "--trail", "0.25", "--size", "320x240", "--film", "b%d.png"});
  ASSERT_TRUE(again.waitForFinished(patience));
  for (const char* number : {"0", "1", "2"}) {
    EXPECT_TRUE(contents(QStringLiteral("a%1.png").arg(number)) ==
                contents(QStringLiteral("b%1.png").arg(number)))
        << number;
  }
}

TEST_F(FilmDialogTest, CancellingLeavesNothing) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  FilmWish wish = small_film();
  wish.times.speed = 0.001;
  wish.times.fps = 25;  // 10 001 frames
  dialog.choose(wish);
  dialog.save(folder_.filePath("a%d.png"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !pictures().empty(); }, patience)) << "it has begun";
  dialog.cancel();
  EXPECT_FALSE(dialog.busy());
  EXPECT_TRUE(QTest::qWaitFor([&] { return pictures().empty(); }, patience))
      << pictures().join(' ').toStdString();
  EXPECT_THAT(dialog.state().toStdString(), testing::HasSubstr("Cancelled"));
}

TEST_F(FilmDialogTest, SaysWhyAFilmCouldNotBeWritten) {
  FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  dialog.choose(small_film());
  dialog.save(folder_.filePath("a.mp4"));
  ASSERT_TRUE(rests(dialog));
  EXPECT_THAT(dialog.state().toStdString(), testing::HasSubstr(".ogv"));
}

TEST_F(FilmDialogTest, RemembersWhatWasChosenButTheStretch) {
  {
    FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
    FilmWish wish = small_film();
    wish.charts = true;
    wish.theme = QStringLiteral("dark");
    dialog.choose(wish);
  }
  subject_.shown = {0.1, 0.2};
  const FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_EQ(dialog.wish().size, QStringLiteral("320x240"));
  EXPECT_EQ(dialog.wish().times.fps, 5);
  EXPECT_TRUE(dialog.wish().charts);
  EXPECT_EQ(dialog.wish().theme, QStringLiteral("dark"));
  EXPECT_DOUBLE_EQ(dialog.wish().times.from, 0.1);
}

TEST_F(FilmDialogTest, TakesNoFileThatIsThere) {
  const FilmDialog dialog(subject_, FEEDSCOPE_EXECUTABLE);
  EXPECT_TRUE(dialog.proposed_file().endsWith(QStringLiteral("/part-film.ogv")));
  QFile taken(folder_.filePath("part-film.ogv"));
  ASSERT_TRUE(taken.open(QIODevice::WriteOnly));
  EXPECT_TRUE(dialog.proposed_file().endsWith(QStringLiteral("/part-film-2.ogv")));
}

TEST(FilmWish, BecomesTheArgumentsOfTheCommand) {
  FilmWish wish;
  wish.times = {.from = 0.125, .to = 12, .speed = 0.5, .fps = 30};
  EXPECT_EQ(film_arguments(wish, "s"), (QStringList{"s", "--from=0.125", "--to=12", "--speed=0.5", "--fps=30",
                                                    "--trail=0", "--size=1280x720"}));
  wish.charts = true;
  wish.theme = QStringLiteral("dark");
  wish.language = QStringLiteral("fr");
  EXPECT_EQ(film_arguments(wish, "s").mid(7), (QStringList{"--theme=dark", "--language=fr", "--charts"}));
}

}  // namespace
}  // namespace feedscope::ui
