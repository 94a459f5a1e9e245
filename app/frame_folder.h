#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "ui/report/frame_pattern.h"

namespace feedscope {

/// The pictures of a film, which are there all or not at all: written into a folder of their own beside their
/// places, moved there by commit(), and removed with this otherwise.
class FrameFolder {
 public:
  /// `pattern` as of FramePattern. Throws InputError for one that is none, and where its folder is missing or
  /// cannot be written.
  explicit FrameFolder(const std::string& pattern);
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  /// The bytes of the next picture. Throws InputError if they could not be written (disk full).
  void add(const std::string& bytes);
  /// Throws InputError naming the picture that could not be moved to its place.
  void commit();

  /// A picture of an older, longer film that would be taken for the next one of this; empty: there is none.
  std::string left_over() const;

 private:
  std::filesystem::path part(std::size_t k) const;

  std::string name_;
  ui::FramePattern pattern_;
  std::filesystem::path folder_;  ///< of the parts
  std::size_t count_ = 0;
};

}  // namespace feedscope
