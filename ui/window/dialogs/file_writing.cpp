#include "ui/window/dialogs/file_writing.h"

#include <QFileInfo>

namespace feedscope::ui {

FileWriting::FileWriting(const QString& executable, const QStringList& command, StateLine& state,
                         QObject* parent)
    : QObject(parent), state_(state), process_(executable, command) {
  connect(&process_, &CommandProcess::progressed, this, &FileWriting::progressed);
  connect(&process_, &CommandProcess::failed, this, [this](const QString& message) {
    emit ended();
    state_.say_failure(message);
  });
  connect(&process_, &CommandProcess::done, this, [this] {
    const QString message = tr("%1 has been written").arg(name_);
    emit ended();
    state_.say(message);
    emit saved(message);
  });
}

void FileWriting::start(const QStringList& arguments, const QString& option, const QString& file) {
  const QFileInfo target(file);
  name_ = target.fileName();
  state_.say(tr("Writing %1 …").arg(name_));
  process_.start(arguments + QStringList{QStringLiteral("%1=%2").arg(option, name_)}, target.absolutePath());
}

}  // namespace feedscope::ui
