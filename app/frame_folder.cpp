#include "app/frame_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/base/error.h"
#include "core/base/this_process.h"

namespace feedscope {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw InputError(fmt::format("cannot write '{}': {}", name, reason));
}

}  // namespace

FrameFolder::FrameFolder(const std::string& pattern) : name_(pattern), pattern_(pattern) {
  const fs::path place = fs::absolute(pattern_.file(0)).parent_path();
  std::error_code error;
  if (!fs::is_directory(place, error)) {
    refuse(pattern, fmt::format("there is no folder '{}'; create it first", place.string()));
  }
  folder_ = place / fmt::format(".feedscope-{}.part", process_id());
  if (!fs::create_directory(folder_, error)) {
    refuse(pattern, error ? error.message() : fmt::format("'{}' is there already", folder_.string()));
  }
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path FrameFolder::part(std::size_t k) const {
  return folder_ / fmt::format("{}.png", k);
}

void FrameFolder::add(const std::string& bytes) {
  errno = 0;
  std::ofstream file(part(count_), std::ios::binary);
  file << bytes;
  file.close();
  if (!file) {
    const int reason = errno;
    refuse(pattern_.file(count_),
           reason != 0 ? std::generic_category().message(reason) : "not everything could be written");
  }
  ++count_;
}

void FrameFolder::commit() {
  for (std::size_t k = 0; k < count_; ++k) {
    std::error_code error;
    fs::rename(part(k), pattern_.file(k), error);
    if (error) {
      refuse(pattern_.file(k), error.message());
    }
  }
}

std::string FrameFolder::left_over() const {
  const std::string next = pattern_.file(count_);
  std::error_code ignored;
  return fs::exists(next, ignored) ? next : std::string();
}

}  // namespace feedscope
