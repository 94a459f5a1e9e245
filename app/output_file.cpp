#include "app/output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <iostream>
#include <system_error>

#include "app/part_files.h"
#include "core/base/error.h"
#include "core/base/this_process.h"

namespace feedscope {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw InputError(fmt::format("cannot write '{}': {}", name, reason));
}

std::string last_error() {
  return std::generic_category().message(errno);
}

/// Where links and "." are resolved, the file itself need not be there.
fs::path place_of(const std::string& name) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  return error ? fs::path(name) : place;
}

}  // namespace

OutputFile::OutputFile(const std::string& name) : name_(name) {
  if (name == "-") {
    return;
  }
  target_ = place_of(name);
  std::error_code ignored;
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) {
    fail(name, "it is a folder");
  }
  if (fs::exists(status) && !may_write(target_)) {
    fail(name, last_error());
  }
  const bool device = fs::exists(status) && !fs::is_regular_file(status);
  written_ = device ? target_ : fs::path(fmt::format("{}.{}.part", target_.string(), process_id()));
  if (!device) {
    part_files::remember(written_);
  }
  file_.open(written_, std::ios::binary);
  if (!file_) {
    const std::string reason = last_error();
    part_files::forget(written_);
    fail(name, reason);
  }
  if (fs::is_regular_file(status)) {
    fs::permissions(written_, status.permissions(), ignored);
  }
}

OutputFile::~OutputFile() {
  if (!committed_ && !written_.empty() && written_ != target_) {
    std::error_code ignored;
    fs::remove(written_, ignored);
  }
  part_files::forget(written_);
}

std::ostream& OutputFile::stream() {
  return written_.empty() ? std::cout : file_;
}

void OutputFile::commit() {
  errno = 0;
  stream().flush();
  if (!stream()) {
    fail(name_, errno != 0 ? last_error() : "not everything could be written");
  }
  file_.close();
  if (!written_.empty() && written_ != target_) {
    std::error_code error;
    fs::rename(written_, target_, error);
    if (error) {
      fail(name_, error.message());
    }
  }
  committed_ = true;
}

void check_outputs(const std::string& input, const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) {
      continue;
    }
    std::error_code ignored;
    if (outputs[i] != "-" && fs::is_regular_file(input, ignored) &&
        fs::equivalent(input, outputs[i], ignored)) {
      fail(outputs[i], "it is the program itself; give another file");
    }
    for (std::size_t j = 0; j < i; ++j) {
      const bool same =
          outputs[i] == outputs[j] || (!outputs[j].empty() && outputs[i] != "-" && outputs[j] != "-" &&
                                       place_of(outputs[i]) == place_of(outputs[j]));
      if (same) {
        fail(outputs[i], "two results would be written there; give two files");
      }
    }
  }
}

}  // namespace feedscope
