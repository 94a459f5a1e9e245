#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace feedscope {

/// The text of a trace, line by line or piece by piece, of a file (packed by gzip or not) or from memory; it
/// holds one piece of a mebibyte at a time.
class TraceText {
 public:
  /// Throws InputError naming file and reason if it cannot be opened.
  TraceText(const std::filesystem::path& file, Progress* progress);
  /// `name` stands for the file in messages; the text must outlive this.
  TraceText(std::string_view text, std::string name);
  ~TraceText();
  TraceText(const TraceText&) = delete;
  TraceText& operator=(const TraceText&) = delete;

  const std::string& name() const { return name_; }
  /// The first part of the text, without moving on.
  std::string_view head();
  /// Next line without its end; false behind the last. Throws InputError for a line longer than a piece, a
  /// damaged file, and Cancelled.
  bool next_line(std::string_view& line);
  /// Next piece as it comes; empty behind the last. Throws as next_line().
  std::string_view next_piece();
  std::uint32_t line_number() const { return line_; }  ///< of the line read last, from 1

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
