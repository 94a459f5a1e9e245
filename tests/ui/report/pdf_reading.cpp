#include "tests/ui/report/pdf_reading.h"

#include <algorithm>
#include <cctype>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFOutlineDocumentHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <sstream>

namespace feedscope::test {
namespace {

using Bookmark = PdfReading::Bookmark;

int number_of(std::vector<QPDFPageObjectHelper>& pages, QPDFObjectHandle page) {
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (pages[i].getObjectHandle().getObjGen() == page.getObjGen()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void collect(QPDF& pdf, const std::vector<QPDFOutlineObjectHelper>& items, int level,
             std::vector<Bookmark>& found) {
  std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(pdf).getAllPages();
  for (QPDFOutlineObjectHelper item : items) {
    found.push_back({level, item.getTitle(), number_of(pages, item.getDestPage())});
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

std::vector<PdfReading::Link> PdfReading::links() {
  std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(*pdf_).getAllPages();
  std::vector<Link> found;
  for (std::size_t page = 0; page < pages.size(); ++page) {
    QPDFObjectHandle helper = pages[page].getObjectHandle();
    QPDFObjectHandle annotations = helper.getKey("/Annots");
    for (int i = 0; annotations.isArray() && i < annotations.getArrayNItems(); ++i) {
      QPDFObjectHandle link = annotations.getArrayItem(i);
      found.push_back({static_cast<int>(page), link.getKey("/Contents").getUTF8Value(),
                       number_of(pages, link.getKey("/Dest").getArrayItem(0))});
    }
  }
  return found;
}

namespace {

void collect_tags(QPDFObjectHandle element, std::vector<PdfReading::Tag>& found) {
  PdfReading::Tag tag;
  if (element.hasKey("/S")) {
    tag.type = element.getKey("/S").getName().substr(1);
    tag.alternative = element.hasKey("/Alt") ? element.getKey("/Alt").getUTF8Value() : "";
  }
  const std::size_t place = found.size();
  found.push_back(tag);
  QPDFObjectHandle kids = element.getKey("/K");
  for (int i = 0; i < kids.getArrayNItems(); ++i) {
    if (kids.getArrayItem(i).hasKey("/MCID")) {
      ++found[place].pieces;
    } else {
      collect_tags(kids.getArrayItem(i), found);
    }
  }
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

std::vector<PdfReading::Tag> PdfReading::tags() {
  std::vector<Tag> found;
  if (pdf_->getRoot().hasKey("/StructTreeRoot")) {
    collect_tags(pdf_->getRoot().getKey("/StructTreeRoot"), found);
  }
  return found;
}

std::vector<std::pair<double, double>> PdfReading::line_ends(std::size_t page) {
  QPDFObjectHandle object = QPDFPageDocumentHelper(*pdf_).getAllPages().at(page).getObjectHandle();
  const auto bytes = object.getKey("/Contents").getStreamData();
  std::istringstream words(std::string(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()));
  std::vector<std::pair<double, double>> ends;
  std::string x;
  std::string y;
  for (std::string word; words >> word;) {
    if (word == "l") {
      ends.emplace_back(std::stod(x), std::stod(y));
    }
    x = std::exchange(y, word);
  }
  return ends;
}

std::size_t PdfReading::marked_contents() {
  std::size_t count = 0;
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(*pdf_).getAllPages()) {
    QPDFObjectHandle object = page.getObjectHandle();
    const auto bytes = object.getKey("/Contents").getStreamData();
    const std::string text(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize());
    count += count_of(text, " BDC\n");
    if (count_of(text, " BDC\n") + count_of(text, " BMC\n") != count_of(text, "EMC\n")) {
      return 0;
    }
  }
  return count;
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
