#include "ui/window/handout_command.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSignalBlocker>

#include "ui/shared/panel_action.h"
#include "ui/shared/paths.h"

namespace feedscope::ui {

HandoutCommand::HandoutCommand(const LessonDesk& desk, QString executable, QWidget& window)
    : QObject(&window),
      desk_(desk),
      executable_(std::move(executable)),
      window_(window),
      action_(make_action(
          &window, tr("&Hand-out of the lesson …"),
          tr("Text, pictures, questions and answers of the open lesson as PDF or HTML, to print"))) {
  set_everyday_words(action_, tr("print paper class lesson worksheet exercise"));
  const auto follow = [this] { action_->setEnabled(desk_.lesson() != nullptr); };
  connect(&desk_, &LessonDesk::opened, action_, follow);
  follow();
  connect(action_, &QAction::triggered, this, &HandoutCommand::ask);
  connect(&process_, &QProcess::finished, this, &HandoutCommand::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      emit failed(tr("%1 cannot be started: %2").arg(executable_, process_.errorString()));
    }
  });
}

HandoutCommand::~HandoutCommand() {
  cancel();
}

void HandoutCommand::cancel() {
  if (process_.state() == QProcess::NotRunning) {
    return;
  }
  const QSignalBlocker silent(process_);
  process_.terminate();           // it removes what it has begun to write
  constexpr int patience = 2000;  // [ms]
  if (!process_.waitForFinished(patience)) {
    process_.kill();
    process_.waitForFinished();
  }
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
  cancel();
  file_ = file;
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.start(executable_, {QStringLiteral("lessons"), to_qstring(lesson->file), QStringLiteral("--out"),
                               file, QStringLiteral("--language"), QString::fromStdString(lesson->language)});
}

void HandoutCommand::end(int code, QProcess::ExitStatus status) {
  const QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
  if (status == QProcess::NormalExit && code == 0) {
    emit done(tr("Saved as %1.").arg(file_));
  } else {
    emit failed(said.isEmpty() ? tr("The hand-out could not be made (exit code %1).").arg(code) : said);
  }
}

}  // namespace feedscope::ui
