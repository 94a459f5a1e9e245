#include "ui/window/handout_command.h"

#include <QFileDialog>
#include <QFileInfo>

#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

HandoutCommand::HandoutCommand(const LessonDesk& desk, QString executable, QWidget& window)
    : QObject(&window),
      desk_(desk),
      window_(window),
      action_(make_action(
          &window, tr("&Hand-out of the lesson …"),
          tr("Text, pictures, questions and answers of the open lesson as PDF or HTML, to print"))),
      process_(std::move(executable), {QStringLiteral("lessons")}) {
  set_everyday_words(action_, tr("print paper class lesson worksheet exercise"));
  const auto follow = [this] { action_->setEnabled(desk_.lesson() != nullptr); };
  connect(&desk_, &LessonDesk::opened, action_, follow);
  follow();
  connect(action_, &QAction::triggered, this, &HandoutCommand::ask);
  connect(&process_, &CommandProcess::done, this, [this] { emit done(tr("Saved as %1.").arg(file_)); });
  connect(&process_, &CommandProcess::failed, this, &HandoutCommand::failed);
}

void HandoutCommand::ask() {
  if (desk_.lesson() == nullptr) {
    return;
  }
  QString file = QFileDialog::getSaveFileName(
      &window_, tr("Save hand-out as"), QString::fromStdString(desk_.lesson()->id) + QStringLiteral(".pdf"),
      tr("Hand-outs (*.pdf *.html)"));
  if (!file.isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty()) {
      file += QStringLiteral(".pdf");
    }
    write(file);
  }
}

void HandoutCommand::write(const QString& file) {
  const Lesson* lesson = desk_.lesson();
  if (lesson == nullptr) {
    return;
  }
  file_ = file;
  process_.start({to_qstring(lesson->file), QStringLiteral("--out"), file, QStringLiteral("--language"),
                  QString::fromStdString(lesson->language)},
                 {});
}

}  // namespace feedscope::ui
