#include "tests/ui/report/pdf_reading.h"

#include <algorithm>
#include <cctype>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFOutlineDocumentHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

namespace feedscope::test {
namespace {

using Bookmark = PdfReading::Bookmark;

void collect(QPDF& pdf, const std::vector<QPDFOutlineObjectHelper>& items, int level,
             std::vector<Bookmark>& found) {
  std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(pdf).getAllPages();
  for (QPDFOutlineObjectHelper item : items) {
    Bookmark bookmark{level, item.getTitle(), -1};
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (pages[i].getObjectHandle().getObjGen() == item.getDestPage().getObjGen()) {
        bookmark.page = static_cast<int>(i);
      }
    }
    found.push_back(bookmark);
    collect(pdf, item.getKids(), level + 1, found);
  }
}

}  // namespace

PdfReading::PdfReading(std::string bytes) : bytes_(std::move(bytes)), pdf_(std::make_unique<QPDF>()) {
  pdf_->processMemoryFile("read back", bytes_.data(), bytes_.size());
}

PdfReading::~PdfReading() = default;

std::size_t PdfReading::page_count() {
  return QPDFPageDocumentHelper(*pdf_).getAllPages().size();
}

std::pair<double, double> PdfReading::page_size(std::size_t page) {
  const auto box = QPDFPageDocumentHelper(*pdf_).getAllPages().at(page).getMediaBox().getArrayAsRectangle();
  return {box.urx - box.llx, box.ury - box.lly};
}

std::string PdfReading::language() {
  return pdf_->getRoot().getKey("/Lang").getUTF8Value();
}

std::string PdfReading::info(const std::string& key) {
  QPDFObjectHandle value = pdf_->getTrailer().getKey("/Info").getKey(key);
  return value.isString() ? value.getUTF8Value() : "";
}

std::vector<Bookmark> PdfReading::bookmarks() {
  std::vector<Bookmark> found;
  collect(*pdf_, QPDFOutlineDocumentHelper(*pdf_).getTopLevelOutlines(), 1, found);
  return found;
}

bool PdfReading::fonts_embedded() {
  std::size_t fonts = 0;
  for (QPDFObjectHandle object : pdf_->getAllObjects()) {
    if (object.isDictionaryOfType("/FontDescriptor")) {
      ++fonts;
      if (!object.hasKey("/FontFile2") && !object.hasKey("/FontFile3") && !object.hasKey("/FontFile")) {
        return false;
      }
    }
  }
  return fonts > 0;
}

std::vector<std::string> PdfReading::copied_ligatures() {
  std::vector<std::string> found;
  for (QPDFObjectHandle object : pdf_->getAllObjects()) {
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

std::vector<std::pair<int, int>> PdfReading::images() {
  std::vector<std::pair<int, int>> found;
  for (QPDFObjectHandle object : pdf_->getAllObjects()) {
    if (object.isStream() && object.getDict().getKey("/Subtype").isNameAndEquals("/Image") &&
        !object.getDict().getKey("/ColorSpace").isNameAndEquals("/DeviceGray")) {
      found.emplace_back(object.getDict().getKey("/Width").getIntValueAsInt(),
                         object.getDict().getKey("/Height").getIntValueAsInt());
    }
  }
  return found;
}

}  // namespace feedscope::test
