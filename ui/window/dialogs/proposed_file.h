#pragma once

#include <QString>
#include <filesystem>

namespace feedscope::ui {

/// Initial folder for files on `program`: its folder, or the user's documents if it is a sample of Feedscope
/// or its folder is not writable. "" for an empty path.
QString folder_for_files_of(const std::filesystem::path& program);

/// "FOLDER/NAME-WHAT.ENDING" in that folder, followed by a number if such a file exists, so that no file is
/// overwritten. `ending`: without its dot. For an empty path "feedscope-WHAT.ENDING".
QString proposed_file(const std::filesystem::path& program, const QString& what, const QString& ending);

}  // namespace feedscope::ui
