#include "ui/session/session_file.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonDocument>
#include <QSaveFile>

#include "core/base/error.h"
#include "ui/session/session_json.h"

namespace feedscope::ui {
namespace {

constexpr qint64 largest_file = 64LL << 20;  // bytes; a session of a thousand annotations is a few hundred KB

/// "line 3, column 7" of an offset in a text.
Message place_of(const QByteArray& text, qsizetype offset) {
  const QByteArray before = text.left(offset);
  const qsizetype line = before.count('\n') + 1;
  return message(NC_("core", "line {}, column {}"), line, offset - before.lastIndexOf('\n'));
}

QByteArray read_bytes(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) {
    throw InputError(message(NC_("core", "cannot read session '{}': {}"), name.toStdString(),
                             file.errorString().toStdString()));
  }
  if (file.size() > largest_file) {
    throw InputError(
        message(NC_("core", "'{}' is larger than 64 MiB and cannot be a session"), name.toStdString()));
  }
  return file.readAll();
}

}  // namespace

bool is_session_file(const std::filesystem::path& file) {
  return file.extension() == session_suffix;
}

QByteArray session_bytes(const Session& session, const std::filesystem::path& folder) {
  return QJsonDocument(to_json(session, folder)).toJson(QJsonDocument::Indented);
}

void write_session(const Session& session, const std::filesystem::path& file) {
  const QByteArray bytes = session_bytes(session, std::filesystem::absolute(file).parent_path());
  QSaveFile out(to_qstring(file));
  if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size() || !out.commit()) {
    throw InputError(message(NC_("core", "cannot write session '{}': {}"), file.string(),
                             out.errorString().toStdString()));
  }
}

void write_lesson_work(const LessonWork& work, QIODevice& out) {
  out.write(QJsonDocument(lesson_work_json(work)).toJson());
}

namespace {

/// Result of `read` for the JSON in a file; adds the file's name to exceptions.
template <class Read>
auto read_file(const std::filesystem::path& file, const Read& read) {
  const QString name = to_qstring(file);
  const QByteArray bytes = read_bytes(name);
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
  if (error.error != QJsonParseError::NoError) {
    throw InputError(message(NC_("core", "'{}' is not a session: {} ({})"), name.toStdString(),
                             error.errorString().toStdString(), place_of(bytes, error.offset)));
  }
  try {
    return read(document.object());
  } catch (const InputError& reason) {
    throw InputError(
        message(NC_("core", "cannot use session '{}': {}"), name.toStdString(), reason.message()));
  }
}

}  // namespace

ReadSession read_session_file(const std::filesystem::path& file) {
  return read_file(file, [&](const QJsonObject& json) {
    return read_session(json, std::filesystem::absolute(file).parent_path(), shipped_machines());
  });
}

LessonWork read_lesson_work(const std::filesystem::path& file) {
  return read_file(file, [](const QJsonObject& json) { return read_lesson_work(json); });
}

QByteArray hash_of(const std::filesystem::path& file) {
  QFile in(to_qstring(file));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return in.open(QIODevice::ReadOnly) && hash.addData(&in) ? hash.result().toHex() : QByteArray();
}

}  // namespace feedscope::ui
