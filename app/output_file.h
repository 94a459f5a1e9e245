#pragma once

#include <deque>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace feedscope {

/// Passes text on to another buffer and keeps the reason of the first failure.
class WatchedBuffer : public std::streambuf {
 public:
  /// `inner` must outlive it.
  explicit WatchedBuffer(std::streambuf& inner) : inner_(inner) {}
  /// errno of the failure; 0 if all was written or the system gave no reason.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  void keep_error(bool arrived);

  std::streambuf& inner_;
  int error_ = 0;
};

/// A result file, written whole or not at all: to a temporary file next to its place, which commit() moves
/// there.
/// Removed if a signal ends the process before.
/// "-" is standard output; devices and pipes are written directly.
class OutputFile {
 public:
  /// Throws InputError naming the file if it cannot be written, before any work is done for it.
  explicit OutputFile(const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// The file until commit(), for a library that writes to a named file instead of the stream; empty for
  /// standard output.
  const std::filesystem::path& written_to() const { return written_; }
  /// Writes everything to the disk, but not yet to its place. Throws InputError naming the file if not
  /// everything could be written (disk full).
  void finish();
  /// Finishes the file and moves it to its place, where it is whole even after a power cut. Throws as
  /// finish().
  void commit();

 private:
  std::string name_;
  std::filesystem::path target_;
  std::filesystem::path written_;  ///< temporary file, or target_ for devices; empty for standard output
  std::filebuf file_;
  WatchedBuffer buffer_;
  std::ostream stream_;
  bool finished_ = false;
  bool committed_ = false;
};

/// The result files of one command: all of them are written, or none.
class OutputFiles {
 public:
  /// Opens another file; returns its stream, which lives as long as this. Throws as the constructor of
  /// OutputFile.
  std::ostream& add(const std::string& name) { return files_.emplace_back(name).stream(); }
  /// Finishes all files, then moves them to their places. Throws as OutputFile::finish().
  void commit();

 private:
  std::deque<OutputFile> files_;  // its elements are not moved in memory
};

/// Throws InputError if two outputs, or an output and the input, are the same file. "" means no output.
void check_outputs(const std::string& input, const std::vector<std::string>& outputs,
                   const std::string& what = "the program itself");

}  // namespace feedscope
