#pragma once

#include <QIODevice>

#include "ui/session/session_json.h"

namespace feedscope::ui {

inline constexpr const char* session_suffix = ".feedscope";

/// By the end of its name.
bool is_session_file(const std::filesystem::path& file);

/// As the bytes of a session file that is in `folder`.
QByteArray session_bytes(const Session& session, const std::filesystem::path& folder);

/// Writes the whole file or leaves what was there. Throws InputError naming file and reason.
void write_session(const Session& session, const std::filesystem::path& file);

/// Throws InputError naming the file, and line and column where it is no JSON; and what read_session throws.
ReadSession read_session_file(const std::filesystem::path& file);

/// Only what was done in lessons, for read_lesson_work().
void write_lesson_work(const LessonWork& work, QIODevice& out);
/// What was done in lessons, of a session file or of what write_lesson_work() has written. Throws as
/// read_session_file().
LessonWork read_lesson_work(const std::filesystem::path& file);

/// SHA-256 of a file's bytes in hex; empty if it cannot be read.
QByteArray hash_of(const std::filesystem::path& file);

}  // namespace feedscope::ui
