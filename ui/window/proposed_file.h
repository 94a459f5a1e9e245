#pragma once

#include <QString>
#include <filesystem>

namespace feedscope::ui {

/// Where files that belong to `program` are proposed: beside it, but in the folder of the user's documents
/// where it is one of the samples that come with Feedscope, or its folder cannot be written to. Of an empty
/// path: "".
QString folder_for_files_of(const std::filesystem::path& program);

/// "FOLDER/NAME-WHAT.ENDING" in that folder, with a number behind it where such a file is there already, so
/// that no file takes the place of another. `ending`: without its dot. Of an empty path
/// "feedscope-WHAT.ENDING".
QString proposed_file(const std::filesystem::path& program, const QString& what, const QString& ending);

}  // namespace feedscope::ui
