#pragma once

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFOutlineDocumentHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <string>
#include <utility>
#include <vector>

namespace feedscope::test {

/// A PDF file as a reader finds it.
class PdfReading {
 public:
  explicit PdfReading(std::string bytes) : bytes_(std::move(bytes)) {
    pdf_.processMemoryFile("read back", bytes_.data(), bytes_.size());
  }
  PdfReading(const PdfReading&) = delete;
  PdfReading& operator=(const PdfReading&) = delete;

  std::size_t page_count() { return QPDFPageDocumentHelper(pdf_).getAllPages().size(); }
  /// Width and height of a page [points].
  std::pair<double, double> page_size(std::size_t page) {
    const auto box = QPDFPageDocumentHelper(pdf_).getAllPages().at(page).getMediaBox().getArrayAsRectangle();
    return {box.urx - box.llx, box.ury - box.lly};
  }
  std::string info(const std::string& key) {
    QPDFObjectHandle value = pdf_.getTrailer().getKey("/Info").getKey(key);
    return value.isString() ? value.getUTF8Value() : "";
  }

  struct Bookmark {
    int level = 0;
    std::string title;
    int page = -1;  ///< from 0; -1: of none
  };
  std::vector<Bookmark> bookmarks() {
    std::vector<Bookmark> found;
    collect(QPDFOutlineDocumentHelper(pdf_).getTopLevelOutlines(), 1, found);
    return found;
  }

  /// Whether every font of the pages is inside the file.
  bool fonts_embedded() {
    std::size_t fonts = 0;
    for (QPDFObjectHandle object : pdf_.getAllObjects()) {
      if (object.isDictionaryOfType("/FontDescriptor")) {
        ++fonts;
        if (!object.hasKey("/FontFile2") && !object.hasKey("/FontFile3") && !object.hasKey("/FontFile")) {
          return false;
        }
      }
    }
    return fonts > 0;
  }
  /// What copying text gives that nobody has typed: ligatures as characters of their own, U+FB00 to U+FB06,
  /// as the file's maps from glyphs to text have them.
  std::vector<std::string> copied_ligatures() {
    std::vector<std::string> found;
    for (QPDFObjectHandle object : pdf_.getAllObjects()) {
      if (!object.isDictionary() || !object.hasKey("/ToUnicode")) {
        continue;
      }
      const auto map = object.getKey("/ToUnicode").getStreamData();
      std::string text(reinterpret_cast<const char*>(map->getBuffer()), map->getSize());
      std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
      for (std::size_t at = text.find("<FB0"); at != std::string::npos; at = text.find("<FB0", at + 1)) {
        found.push_back(text.substr(at, 6));
      }
    }
    return found;
  }
  /// Pictures in the file: width and height [pixels] of each that is no mask.
  std::vector<std::pair<int, int>> images() {
    std::vector<std::pair<int, int>> found;
    for (QPDFObjectHandle object : pdf_.getAllObjects()) {
      if (object.isStream() && object.getDict().getKey("/Subtype").isNameAndEquals("/Image") &&
          !object.getDict().getKey("/ColorSpace").isNameAndEquals("/DeviceGray")) {
        found.emplace_back(object.getDict().getKey("/Width").getIntValueAsInt(),
                           object.getDict().getKey("/Height").getIntValueAsInt());
      }
    }
    return found;
  }

 private:
  void collect(const std::vector<QPDFOutlineObjectHelper>& items, int level, std::vector<Bookmark>& found) {
    std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(pdf_).getAllPages();
    for (QPDFOutlineObjectHelper item : items) {
      Bookmark bookmark{level, item.getTitle(), -1};
      for (std::size_t i = 0; i < pages.size(); ++i) {
        if (pages[i].getObjectHandle().getObjGen() == item.getDestPage().getObjGen()) {
          bookmark.page = static_cast<int>(i);
        }
      }
      found.push_back(bookmark);
      collect(item.getKids(), level + 1, found);
    }
  }

  std::string bytes_;  // read from as long as `pdf_` lives
  QPDF pdf_;
};

}  // namespace feedscope::test
