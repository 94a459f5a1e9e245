#include "ui/report/command_process.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <utility>

namespace feedscope::ui {

namespace {

/// Stages of the command in order, and the progress at their start.
constexpr std::array<std::pair<const char*, double>, 3> stages{
    {{"reading", 0.0}, {"simulating", 0.05}, {"drawing", 0.35}}};

/// Progress in "progress: drawing 43 %"; negative for any other line.
double fraction_in(const QString& line) {
  static const QRegularExpression pattern(QStringLiteral("^progress: (\\w+) (\\d+) %$"));
  const QRegularExpressionMatch match = pattern.match(line);
  if (!match.hasMatch()) {
    return -1;
  }
  const auto stage =
      std::ranges::find(stages, match.captured(1), [](const auto& known) { return QString(known.first); });
  if (stage == stages.end()) {
    return 0;
  }
  const double end = std::next(stage) == stages.end() ? 1 : std::next(stage)->second;
  return stage->second + (end - stage->second) * match.captured(2).toInt() / 100;
}

constexpr int exit_done = 0;
constexpr int exit_program_errors = 1;  // its file is written

}  // namespace

CommandProcess::CommandProcess(QString executable, QStringList command, QObject* parent)
    : QObject(parent), executable_(std::move(executable)), command_(std::move(command)) {}

CommandProcess::~CommandProcess() {
  cancel();
  constexpr int patience = 10'000;  // [ms]; a frame of a large program takes some seconds
  for (const std::unique_ptr<QProcess>& process : ending_) {
    process->disconnect(this);
    if (!process->waitForFinished(patience)) {
      process->kill();
      process->waitForFinished();
    }
  }
}

void CommandProcess::start(const QStringList& arguments, const QString& folder) {
  cancel();
  said_.clear();
  line_.clear();
  if (process_ != nullptr) {
    process_.release()->deleteLater();  // its last signal may call this
  }
  process_ = std::make_unique<QProcess>();
  connect(process_.get(), &QProcess::readyReadStandardError, this, &CommandProcess::read);
  connect(process_.get(), &QProcess::finished, this, &CommandProcess::end);
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      emit failed(tr("%1 cannot be started: %2").arg(executable_, process_->errorString()));
    }
  });
  process_->setWorkingDirectory(folder);
  process_->setStandardOutputFile(QProcess::nullDevice());
  process_->start(executable_, command_ + arguments);
}

void CommandProcess::cancel() {
  if (!busy()) {
    return;
  }
  QProcess* process = process_.get();
  process->disconnect(this);
  ending_.push_back(std::move(process_));
  connect(process, &QProcess::finished, this, [this, process] { forget(process); });
  process->closeReadChannel(QProcess::StandardError);
  process->terminate();
}

void CommandProcess::forget(const QProcess* ended) {
  const auto found = std::ranges::find(ending_, ended, &std::unique_ptr<QProcess>::get);
  if (found != ending_.end()) {
    found->release()->deleteLater();  // it is emitting a signal
    ending_.erase(found);
  }
}

void CommandProcess::read() {
  line_ += process_->readAllStandardError();
  for (qsizetype end = line_.indexOf('\n'); end >= 0; end = line_.indexOf('\n')) {
    const QString line = QString::fromUtf8(line_.left(end));
    line_.remove(0, end + 1);
    const double fraction = fraction_in(line);
    if (fraction >= 0) {
      emit progressed(fraction);
    } else {
      said_ += line + '\n';
    }
  }
}

void CommandProcess::end(int code, QProcess::ExitStatus status) {
  read();
  if (status == QProcess::NormalExit && (code == exit_done || code == exit_program_errors)) {
    emit done();
  } else {
    emit failed(said_.isEmpty() ? tr("The command failed without a word (exit code %1).").arg(code)
                                : said_.trimmed());
  }
}

}  // namespace feedscope::ui
