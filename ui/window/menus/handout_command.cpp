#include "ui/window/menus/handout_command.h"

#include <QFileDialog>
#include <QFileInfo>

#include "ui/session/session_file.h"
#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

HandoutCommand::HandoutCommand(const LessonDesk& desk, QString executable, QWidget& window)
    : QObject(&window),
      desk_(desk),
      window_(window),
      process_(std::move(executable), {QStringLiteral("lessons")}) {
  add(HandoutReader::learners, tr("Hand-out for &learners …"),
      tr("Questions of the open lesson with room to write, no answers, as PDF or HTML"));
  add(HandoutReader::teacher, tr("Hand-out for the &teacher …"),
      tr("Questions and answers of the open lesson with the numbers they build on, as PDF or HTML"));
  add(HandoutReader::everybody, tr("Hand-out for &everybody …"),
      tr("Questions of the open lesson, and answers on pages of their own, as PDF or HTML"));
  const auto follow = [this] {
    for (QAction* action : actions_) {
      action->setEnabled(desk_.lesson() != nullptr);
    }
  };
  connect(&desk_, &LessonDesk::opened, this, follow);
  follow();
  connect(&process_, &CommandProcess::done, this, [this] { emit done(tr("Saved as %1.").arg(file_)); });
  connect(&process_, &CommandProcess::failed, this, &HandoutCommand::failed);
}

void HandoutCommand::add(HandoutReader reader, const QString& text, const QString& tip) {
  QAction* action = make_action(&window_, text, tip);
  set_everyday_words(action, tr("print paper class lesson worksheet exercise"));
  connect(action, &QAction::triggered, this, [this, reader] { ask(reader); });
  actions_.append(action);
}

void HandoutCommand::ask(HandoutReader reader) {
  if (desk_.lesson() == nullptr) {
    return;
  }
  const std::string& name = handout_readers()[static_cast<std::size_t>(reader)];
  QString file = QFileDialog::getSaveFileName(
      &window_, tr("Save hand-out as"),
      QStringLiteral("%1-%2.pdf")
          .arg(QString::fromStdString(desk_.lesson()->id), QString::fromStdString(name)),
      tr("Hand-outs (*.pdf *.html)"));
  if (!file.isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty()) {
      file += QStringLiteral(".pdf");
    }
    write(reader, file);
  }
}

QStringList HandoutCommand::arguments(const Lesson& lesson, HandoutReader reader) {
  return {to_qstring(std::filesystem::absolute(lesson.file)), QStringLiteral("--language"),
          QString::fromStdString(lesson.language), QStringLiteral("--for"),
          QString::fromStdString(handout_readers()[static_cast<std::size_t>(reader)])};
}

void HandoutCommand::write(HandoutReader reader, const QString& file) {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    return;
  }
  file_ = file;
  QStringList all = arguments(*lesson, reader) + QStringList{QStringLiteral("--out"), file};
  work_ = std::make_unique<QTemporaryFile>();
  if (reader != HandoutReader::teacher && work_->open()) {
    write_lesson_work(desk_.all_work(), *work_);
    work_->close();
    all << QStringLiteral("--session") << work_->fileName();
  }
  process_.start(all, {});
}

}  // namespace feedscope::ui
