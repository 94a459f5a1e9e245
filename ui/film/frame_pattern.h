#pragma once

#include <cstddef>
#include <string>

namespace feedscope::ui {

/// Names of a series of frame files, with one number in printf() notation.
class FramePattern {
 public:
  /// "frames/part-%05d.png". Throws InputError with an example for a name without a number, with two of them,
  /// with one in the name of a folder, or with another conversion.
  explicit FramePattern(const std::string& pattern);
  /// Name of frame `k`, from 0, with its folders.
  std::string file(std::size_t k) const;

 private:
  std::string before_;
  std::string after_;
  bool zeros_ = false;
  std::size_t width_ = 0;
};

}  // namespace feedscope::ui
