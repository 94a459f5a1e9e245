#pragma once

#include <QImage>
#include <QSize>
#include <memory>
#include <string>

namespace feedscope::ui {

/// A film as an Ogg file with Theora video. Two files with the same frames have equal pictures but different
/// bytes, because each has its own serial number.
class OggFilm {
 public:
  /// Whether VTK was built with the required module IOOggTheora. If not, the constructor throws.
  static bool is_available();

  /// Writes to `file`; messages call it `name`.
  OggFilm(const std::string& file, int fps, const std::string& name);
  ~OggFilm();
  OggFilm(const OggFilm&) = delete;
  OggFilm& operator=(const OggFilm&) = delete;

  /// Frames must have equal sizes, even in width and height. Throws InputError if writing fails.
  void add(const QImage& frame);
  /// Completes the file. Throws InputError if not all of it could be written.
  void finish();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace feedscope::ui
