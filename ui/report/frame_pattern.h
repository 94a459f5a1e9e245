#pragma once

#include <cstddef>
#include <string>

namespace feedscope::ui {

/// The files of a series of frames: one number in the name, as printf() writes it.
class FramePattern {
 public:
  /// "frames/part-%05d.png". Throws InputError that shows how to write it for a name without a number, with
  /// two of them, with one in the name of a folder, or of something else.
  explicit FramePattern(const std::string& pattern);
  /// Of frame `k`, from 0, with its folders.
  std::string file(std::size_t k) const;

 private:
  std::string before_;
  std::string after_;
  bool zeros_ = false;
  std::size_t width_ = 0;
};

}  // namespace feedscope::ui
