#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "ui/film/frame_pattern.h"

namespace feedscope {

/// The pictures of a film, written all or not at all. add() writes them into a temporary folder next to their
/// places, commit() moves them there; the destructor removes those not moved.
class FrameFolder {
 public:
  /// `pattern`: as of FramePattern. Throws InputError for an invalid pattern, and if its folder is missing or
  /// not writable.
  explicit FrameFolder(const std::string& pattern);
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  /// The bytes of the next picture. Throws InputError if they could not be written (disk full).
  void add(const std::string& bytes);
  /// Throws InputError naming the picture that could not be moved to its place.
  void commit();

  /// A leftover picture of an older, longer film that would be taken for this film's next; empty: none.
  std::string left_over() const;

 private:
  std::filesystem::path part(std::size_t k) const;

  std::string name_;
  ui::FramePattern pattern_;
  std::filesystem::path folder_;  ///< of the parts, temporary
  std::size_t count_ = 0;
};

}  // namespace feedscope
