#include "core/program/text/subprogram_files.h"

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "core/program/text/scanner.h"

namespace feedscope {

namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), letters::to_upper);
  return text;
}

}  // namespace

void SubprogramFiles::list() {
  listed_ = true;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder_, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->is_regular_file(error)) {
      // Of names that differ only in case the first in sorted order counts, whatever the order of the folder.
      std::filesystem::path& file = files_[upper(entry->path().filename().string())];
      file = file.empty() ? entry->path() : std::min(file, entry->path());
    }
  }
}

std::vector<std::shared_ptr<const SourceText>> SubprogramFiles::all_read() const {
  std::vector<std::shared_ptr<const SourceText>> all;
  for (const auto& [name, text] : read_) {
    if (text != nullptr) {
      all.push_back(text);
    }
  }
  return all;
}

std::shared_ptr<const SourceText> SubprogramFiles::find(const std::vector<std::string>& names) {
  if (folder_.empty()) {
    return nullptr;
  }
  if (!listed_) {
    list();
  }
  for (const std::string& name : names) {
    const auto file = files_.find(upper(name));
    if (file == files_.end()) {
      continue;
    }
    const auto [read, is_new] = read_.try_emplace(file->first);
    if (is_new) {
      try {
        read->second = std::make_shared<const SourceText>(SourceText::from_file(file->second));
      } catch (const InputError&) {
        // Stays empty: the caller reports the missing subprogram.
      }
    }
    if (read->second != nullptr) {
      return read->second;
    }
  }
  return nullptr;
}

}  // namespace feedscope
