#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class QPDF;

namespace feedscope::test {

/// A PDF file as a reader finds it.
class PdfReading {
 public:
  explicit PdfReading(std::string bytes);
  ~PdfReading();
  PdfReading(const PdfReading&) = delete;
  PdfReading& operator=(const PdfReading&) = delete;

  std::size_t page_count();
  /// Width and height of a page [points].
  std::pair<double, double> page_size(std::size_t page);
  std::string info(const std::string& key);
  std::string language();

  struct Bookmark {
    int level = 0;
    std::string title;
    int page = -1;  ///< from 0; -1: of none
  };
  std::vector<Bookmark> bookmarks();

  struct Link {
    int page = -1;  ///< from 0
    std::string title;
    int to_page = -1;  ///< from 0; -1: to none
  };
  std::vector<Link> links();

  /// A part of the structure of a tagged file, in reading order.
  struct Tag {
    std::string type;
    std::string alternative;
    std::size_t pieces = 0;  ///< of the pages' contents
  };
  std::vector<Tag> tags();
  /// Marked contents of all pages, artifacts not counted; every beginning has its end.
  std::size_t marked_contents();

  /// Ends of the lines on a page, as its contents have them.
  std::vector<std::pair<double, double>> line_ends(std::size_t page);

  /// Whether every font of the pages is inside the file.
  bool fonts_embedded();
  /// What copying text gives that nobody has typed: ligatures as characters of their own, U+FB00 to U+FB06,
  /// as the file's maps from glyphs to text have them.
  std::vector<std::string> copied_ligatures();
  /// Pictures in the file: width and height [pixels] of each that is no mask.
  std::vector<std::pair<int, int>> images();

 private:
  std::string bytes_;  // read from as long as `pdf_` lives
  std::unique_ptr<QPDF> pdf_;
};

}  // namespace feedscope::test
