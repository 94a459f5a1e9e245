#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/text/source_text.h"

namespace feedscope {

/// Files called by a program: those in its folder, by name whatever the case. Each is read once.
class SubprogramFiles {
 public:
  /// For an empty `folder` it finds nothing.
  explicit SubprogramFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The first of `names` that is a file in the program's folder; nullptr if none is, or if it cannot be
  /// read.
  std::shared_ptr<const SourceText> find(const std::vector<std::string>& names);

  /// All files read, in the order of their names.
  std::vector<std::shared_ptr<const SourceText>> all_read() const;

 private:
  void list();

  std::filesystem::path folder_;
  bool listed_ = false;
  std::map<std::string, std::filesystem::path> files_;  ///< by upper-case name
  std::map<std::string, std::shared_ptr<const SourceText>> read_;
};

}  // namespace feedscope
