#pragma once

#include <QIODevice>

#include "ui/session/session_json.h"

namespace feedscope::ui {

inline constexpr const char* session_suffix = ".feedscope";

/// Decides by the ending of the file name.
bool is_session_file(const std::filesystem::path& file);

/// The bytes of a session file in `folder`.
QByteArray session_bytes(const Session& session, const std::filesystem::path& folder);

/// Writes the whole file or leaves the old one. Throws InputError naming file and reason.
void write_session(const Session& session, const std::filesystem::path& file);

/// Throws InputError naming the file, with line and column if it is not JSON; and as read_session().
ReadSession read_session_file(const std::filesystem::path& file);

/// Writes the work on lessons only, for read_lesson_work().
void write_lesson_work(const LessonWork& work, QIODevice& out);
/// Work on lessons from a session file or a file of write_lesson_work(). Throws as read_session_file().
LessonWork read_lesson_work(const std::filesystem::path& file);

/// SHA-256 of a file's bytes in hex; empty if it cannot be read.
QByteArray hash_of(const std::filesystem::path& file);

}  // namespace feedscope::ui
