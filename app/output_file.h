#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace feedscope {

/// A result file that is there whole or not at all: written beside its place and moved there by commit(),
/// and removed if a signal ends the process before.
/// "-" is standard output; devices and pipes are written directly.
class OutputFile {
 public:
  /// Throws InputError naming the file if it cannot be written, before any work is done for it.
  explicit OutputFile(const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream();
  /// Throws InputError naming the file if not everything could be written (disk full).
  void commit();

 private:
  std::string name_;
  std::filesystem::path target_;
  std::filesystem::path written_;  ///< temporary file, or target_ for devices; empty for standard output
  std::ofstream file_;
  bool committed_ = false;
};

/// Throws InputError if two outputs, or an output and the input, are the same file. "" stands for no output.
void check_outputs(const std::string& input, const std::vector<std::string>& outputs);

}  // namespace feedscope
