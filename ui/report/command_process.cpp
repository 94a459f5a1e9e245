#include "ui/report/command_process.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <utility>

namespace feedscope::ui {

namespace {

/// Its stages in their order, and how much of the whole is done where they begin.
constexpr std::array<std::pair<const char*, double>, 3> stages{
    {{"reading", 0.0}, {"simulating", 0.05}, {"drawing", 0.35}}};

/// Of "progress: drawing 43 %"; less than 0 for any other line.
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
    : QObject(parent), executable_(std::move(executable)), command_(std::move(command)) {
  connect(&process_, &QProcess::readyReadStandardError, this, &CommandProcess::read);
  connect(&process_, &QProcess::finished, this, &CommandProcess::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      emit failed(tr("%1 cannot be started: %2").arg(executable_, process_.errorString()));
    }
  });
}

CommandProcess::~CommandProcess() {
  cancel();
}

void CommandProcess::start(const QStringList& arguments, const QString& folder) {
  cancel();
  said_.clear();
  line_.clear();
  process_.setWorkingDirectory(folder);
  process_.setStandardOutputFile(QProcess::nullDevice());
  process_.start(executable_, command_ + arguments);
}

void CommandProcess::cancel() {
  if (!busy()) {
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

void CommandProcess::read() {
  line_ += process_.readAllStandardError();
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
