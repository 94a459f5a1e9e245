#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <string>

namespace feedscope::ui {

/// A film as an Ogg file with Theora video. The pictures of two files with the same frames are equal; their
/// bytes are not, because each has a serial number of its own.
class OggFilm {
 public:
  /// Whether VTK was built with what this needs (its module IOOggTheora). Without it the constructor throws.
  static bool is_available();

  /// Writes to `file`, which messages call `name`.
  OggFilm(const std::string& file, int fps, const std::string& name);
  ~OggFilm();
  OggFilm(const OggFilm&) = delete;
  OggFilm& operator=(const OggFilm&) = delete;

  /// All of one size, even in width and height. Throws InputError if it cannot be written.
  void add(const QImage& frame);
  /// Throws InputError if not all of it could be written. Without it, or before it, the file is a part.
  void finish();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace feedscope::ui
