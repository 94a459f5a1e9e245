#include "ui/window/menus/handout_command.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/patience.h"

namespace feedscope::ui {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class HandoutCommandTest : public testing::Test {
 protected:
  void open(LessonDesk& desk) {
    QSignalSpy opened(&desk, &LessonDesk::opened);
    desk.open(find_lesson("3"));
    ASSERT_TRUE(opened.wait(patience));
  }
  std::string contents(const QString& name) const {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll().toStdString();
  }

  QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  LessonDesk desk{model, "fr"};
  QWidget window;
  HandoutCommand command{desk, FEEDSCOPE_EXECUTABLE, window};
};

TEST_F(HandoutCommandTest, NeedsALesson) {
  ASSERT_EQ(command.actions().size(), 3);
  for (const QAction* action : command.actions()) {
    EXPECT_FALSE(action->isEnabled());
  }
  open(desk);
  for (const QAction* action : command.actions()) {
    EXPECT_TRUE(action->isEnabled());
  }
}

TEST_F(HandoutCommandTest, WritesPagesWithPicturesInTheLanguageOfTheLesson) {
  open(desk);
  QSignalSpy done(&command, &HandoutCommand::done);
  command.write(HandoutReader::everybody, folder.filePath("lecon.html"));
  ASSERT_TRUE(done.wait(patience));
  EXPECT_THAT(done[0][0].toString().toStdString(), HasSubstr("lecon.html"));
  const std::string page = contents("lecon.html");
  EXPECT_THAT(page, HasSubstr("lang=\"fr\""));
  EXPECT_THAT(page, HasSubstr("<img"));
  EXPECT_THAT(page, HasSubstr("2,144"));
  command.write(HandoutReader::everybody, folder.filePath("lecon.pdf"));
  ASSERT_TRUE(done.wait(patience));
  EXPECT_THAT(contents("lecon.pdf"), StartsWith("%PDF"));
}

TEST_F(HandoutCommandTest, LearnersGetNoAnswers) {
  open(desk);
  QSignalSpy done(&command, &HandoutCommand::done);
  command.write(HandoutReader::learners, folder.filePath("feuille.html"));
  ASSERT_TRUE(done.wait(patience));
  EXPECT_THAT(contents("feuille.html"), testing::Not(HasSubstr("Réponse")));
  command.write(HandoutReader::teacher, folder.filePath("corrige.html"));
  ASSERT_TRUE(done.wait(patience));
  EXPECT_THAT(contents("corrige.html"), testing::AllOf(HasSubstr("Réponse"), HasSubstr("Calculé")));
}

TEST_F(HandoutCommandTest, SaysWhyItCouldNotBeWritten) {
  open(desk);
  QSignalSpy failed(&command, &HandoutCommand::failed);
  command.write(HandoutReader::everybody, folder.filePath("none/lecon.pdf"));
  ASSERT_TRUE(failed.wait(patience));
  EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("none/lecon.pdf"));
}

}  // namespace
}  // namespace feedscope::ui
