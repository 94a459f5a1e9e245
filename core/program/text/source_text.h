#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace feedscope {

enum class Encoding : std::uint8_t { utf8, latin1 };

/// Text of an NC program, every line as written.
///
/// A file is read in one piece, not mapped: a CAM system that overwrites a mapped file would crash the
/// application that shows it. Control characters of punched tape and serial lines (NUL, DEL, XON, Ctrl-Z ...)
/// become blanks.
class SourceText {
 public:
  static constexpr std::size_t longest_line = 10'000'000;  ///< [bytes]

  SourceText() = default;
  /// Takes a text; `name` is its name in messages. Throws InputError above 4 GiB, for a line longer than
  /// longest_line, and for binary data (many zero bytes).
  SourceText(std::string name, std::string text);

  /// Reads a file, or standard input for "-". Throws InputError if it does not exist, is a directory or
  /// cannot be read, and like the constructor.
  static SourceText from_file(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  /// Folder of the file, to find called files; empty if the text did not come from a file.
  const std::filesystem::path& folder() const { return folder_; }
  /// The same as UTF-8, for display.
  std::string utf8_text() const { return to_utf8(text_); }
  std::string utf8_line(std::uint32_t number) const { return to_utf8(line(number)); }
  /// Latin-1 for invalid UTF-8.
  Encoding encoding() const { return encoding_; }
  /// Bytes that became blanks.
  std::size_t noise_count() const { return noise_count_; }
  /// Number of lines; a last line without line end counts, an empty text has none.
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(starts_.size()); }
  /// Line `number` (1-based) without its line end (LF, CR, CR LF or CR CR LF) and without a byte order mark.
  /// Out of range: empty.
  std::string_view line(std::uint32_t number) const;

 private:
  std::string to_utf8(std::string_view part) const;

  std::string name_;
  std::string text_;
  std::filesystem::path folder_;
  std::vector<std::uint32_t> starts_;  ///< byte offset of every line
  std::size_t noise_count_ = 0;
  Encoding encoding_ = Encoding::utf8;
};

}  // namespace feedscope
