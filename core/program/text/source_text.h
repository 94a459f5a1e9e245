#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

/// The text of an NC program, every line kept as written.
class SourceText {
 public:
  SourceText() = default;
  /// Takes a text; `name` is what messages call it. Throws InputError beyond 4 GiB.
  SourceText(std::string name, std::string text);

  /// Reads a file, or standard input for "-".
  /// Throws InputError if it does not exist, is a directory, cannot be read, exceeds 4 GiB or is binary
  /// (holds a NUL byte).
  static SourceText from_file(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  /// Where the file lies, for what it calls; empty for a text that is no file.
  const std::filesystem::path& folder() const { return folder_; }
  /// Number of lines; a last line without line end counts, an empty text has none.
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(starts_.size()); }
  /// Line `number` (1-based) without its line end (LF, CR, CR LF or CR CR LF) and without a byte order mark.
  /// Out of range: empty.
  std::string_view line(std::uint32_t number) const;

 private:
  std::string name_;
  std::string text_;
  std::filesystem::path folder_;
  std::vector<std::uint32_t> starts_;  ///< byte offset of every line
};

}  // namespace feedscope
