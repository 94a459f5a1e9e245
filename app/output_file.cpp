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

std::string message(int error) {
  return error != 0 ? std::generic_category().message(error) : "not everything could be written";
}

/// Resolves links and "."; the file itself need not exist.
fs::path place_of(const std::string& name) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(name), error);
  return error ? fs::path(name) : place;
}

}  // namespace

WatchedBuffer::int_type WatchedBuffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) {
    return traits_type::not_eof(character);
  }
  errno = 0;
  const int_type written = inner_.sputc(traits_type::to_char_type(character));
  keep_error(!traits_type::eq_int_type(written, traits_type::eof()));
  return written;
}

std::streamsize WatchedBuffer::xsputn(const char* text, std::streamsize size) {
  errno = 0;
  const std::streamsize written = inner_.sputn(text, size);
  keep_error(written == size);
  return written;
}

int WatchedBuffer::sync() {
  errno = 0;
  const int result = inner_.pubsync();
  keep_error(result == 0);
  return result;
}

void WatchedBuffer::keep_error(bool arrived) {
  if (!arrived && error_ == 0) {
    error_ = errno;
  }
}

OutputFile::OutputFile(const std::string& name)
    : name_(name), buffer_(name == "-" ? *std::cout.rdbuf() : file_), stream_(&buffer_) {
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
    fail(name, message(errno));
  }
  const bool device = fs::exists(status) && !fs::is_regular_file(status);
  written_ = device ? target_ : fs::path(fmt::format("{}.{}.part", target_.string(), process_id()));
  if (!device) {
    part_files::remember(written_);
  }
  if (file_.open(written_, std::ios::out | std::ios::binary) == nullptr) {
    const std::string reason = message(errno);
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

void OutputFile::finish() {
  stream_.flush();
  if (!stream_) {
    fail(name_, message(buffer_.error()));
  }
  errno = 0;
  if (!written_.empty() && file_.close() == nullptr) {  // a network drive or a quota may refuse only now
    fail(name_, message(errno));
  }
  if (!written_.empty() && written_ != target_) {
    if (const int error = flush_to_disk(written_); error != 0) {
      fail(name_, message(error));
    }
  }
  finished_ = true;
}

void OutputFile::commit() {
  if (!finished_) {
    finish();
  }
  if (!written_.empty() && written_ != target_) {
    std::error_code error;
    fs::rename(written_, target_, error);
    if (error) {
      fail(name_, error.message());
    }
  }
  committed_ = true;
}

void OutputFiles::commit() {
  for (OutputFile& file : files_) {
    file.finish();
  }
  for (OutputFile& file : files_) {
    file.commit();
  }
}

void check_outputs(const std::string& input, const std::vector<std::string>& outputs,
                   const std::string& what) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) {
      continue;
    }
    std::error_code ignored;
    if (outputs[i] != "-" && fs::is_regular_file(input, ignored) &&
        fs::equivalent(input, outputs[i], ignored)) {
      fail(outputs[i], "it is " + what + "; give another file");
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
