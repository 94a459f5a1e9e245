#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace feedscope {

/// Text of a trace, line by line or in pieces, from a file (with or without gzip) or from memory; at most one
/// piece of a mebibyte is in memory at a time.
class TraceText {
 public:
  /// Throws InputError with file and reason if it cannot be opened.
  TraceText(const std::filesystem::path& file, Progress* progress);
  /// `name` replaces the file in messages; the text must outlive this.
  TraceText(std::string_view text, std::string name);
  ~TraceText();
  TraceText(const TraceText&) = delete;
  TraceText& operator=(const TraceText&) = delete;

  const std::string& name() const { return name_; }
  /// First part of the text; does not advance.
  std::string_view head();
  /// Reads the next line without its line ending; false after the last one. Throws InputError for a line
  /// longer than a piece or a damaged file, and Cancelled.
  bool next_line(std::string_view& line);
  /// Next raw piece; empty after the last one. Throws as next_line() does.
  std::string_view next_piece();
  std::uint32_t line_number() const { return line_; }  ///< of the last line read, 1-based

 private:
  bool fill();
  struct File;

  std::string name_;
  std::unique_ptr<File> file_;
  std::string_view memory_;
  std::string buffer_;
  std::size_t begin_ = 0;
  std::uint32_t line_ = 0;
  bool started_ = false;
  Progress* progress_ = nullptr;
};

}  // namespace feedscope
