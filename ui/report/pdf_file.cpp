#include "ui/report/pdf_file.h"

#include <QHashFunctions>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

namespace feedscope::ui {

namespace {

QPDFObjectHandle text_object(const QString& text) {
  return QPDFObjectHandle::newUnicodeString(text.toStdString());
}

/// One entry of the outline, not yet linked to its neighbours.
QPDFObjectHandle outline_item(QPDF& pdf, const PdfBookmark& bookmark,
                              const std::vector<QPDFPageObjectHelper>& pages) {
  QPDFObjectHandle item = pdf.makeIndirectObject(QPDFObjectHandle::newDictionary());
  item.replaceKey("/Title", text_object(bookmark.title));
  QPDFPageObjectHelper page = pages.at(static_cast<std::size_t>(bookmark.page));
  const double height = page.getMediaBox().getArrayAsRectangle().ury;
  QPDFObjectHandle place = QPDFObjectHandle::newArray();
  place.appendItem(page.getObjectHandle());
  place.appendItem(QPDFObjectHandle::newName("/XYZ"));
  place.appendItem(QPDFObjectHandle::newNull());
  place.appendItem(QPDFObjectHandle::newReal(height - bookmark.top, 2));
  place.appendItem(QPDFObjectHandle::newNull());
  item.replaceKey("/Dest", place);
  return item;
}

/// Links items into the tree that their levels say; a level that is omitted counts as the next one.
class OutlineBuilder {
 public:
  explicit OutlineBuilder(QPDFObjectHandle root) { open_.push_back({std::move(root), {}, 0, 0}); }

  void add(QPDFObjectHandle item, int level) {
    while (open_.size() > 1 && open_.back().level >= level) {
      close();
    }
    Node& parent = open_.back();
    item.replaceKey("/Parent", parent.object);
    if (parent.count == 0) {
      parent.object.replaceKey("/First", item);
    } else {
      parent.last.replaceKey("/Next", item);
      item.replaceKey("/Prev", parent.last);
    }
    parent.object.replaceKey("/Last", item);
    parent.last = item;
    ++parent.count;
    open_.push_back({std::move(item), {}, 0, level});
  }

  void finish() {
    while (open_.size() > 1) {
      close();
    }
    open_.back().object.replaceKey("/Count", QPDFObjectHandle::newInteger(open_.back().count));
  }

 private:
  struct Node {
    QPDFObjectHandle object;
    QPDFObjectHandle last;  ///< of its items
    int count = 0;          ///< of its items
    int level = 0;
  };

  /// Its items are folded away at first.
  void close() {
    if (open_.back().count > 0) {
      open_.back().object.replaceKey("/Count", QPDFObjectHandle::newInteger(-open_.back().count));
    }
    open_.pop_back();
  }

  std::vector<Node> open_;
};

void add_outline(QPDF& pdf, const std::vector<PdfBookmark>& bookmarks) {
  if (bookmarks.empty()) {
    return;
  }
  const std::vector<QPDFPageObjectHelper> pages = QPDFPageDocumentHelper(pdf).getAllPages();
  QPDFObjectHandle root = pdf.makeIndirectObject(QPDFObjectHandle::newDictionary());
  root.replaceKey("/Type", QPDFObjectHandle::newName("/Outlines"));
  OutlineBuilder builder(root);
  for (const PdfBookmark& bookmark : bookmarks) {
    builder.add(outline_item(pdf, bookmark, pages), bookmark.level);
  }
  builder.finish();
  pdf.getRoot().replaceKey("/Outlines", root);
  pdf.getRoot().replaceKey("/PageMode", QPDFObjectHandle::newName("/UseOutlines"));
}

void set_properties(QPDF& pdf, const PdfProperties& properties) {
  QPDFObjectHandle info = pdf.makeIndirectObject(QPDFObjectHandle::newDictionary());
  info.replaceKey("/Title", text_object(properties.title));
  info.replaceKey("/Creator", text_object(QStringLiteral("Feedscope")));
  if (!properties.author.isEmpty()) {
    info.replaceKey("/Author", text_object(properties.author));
  }
  if (!properties.date.isEmpty()) {
    info.replaceKey("/CreationDate", text_object(properties.date));
  }
  pdf.getTrailer().replaceKey("/Info", info);
  if (!properties.language.isEmpty()) {
    pdf.getRoot().replaceKey("/Lang", text_object(properties.language));
  }
  QPDFObjectHandle view = QPDFObjectHandle::newDictionary();
  view.replaceKey("/DisplayDocTitle", QPDFObjectHandle::newBool(true));
  pdf.getRoot().replaceKey("/ViewerPreferences", view);
  pdf.getRoot().removeKey("/Metadata");
  pdf.getTrailer().removeKey(
      "/ID");  // of Qt 6.8, another one each time; the writer makes one of the contents
}

}  // namespace

StableOrder::StableOrder() {
  QHashSeed::setDeterministicGlobalSeed();
}

StableOrder::~StableOrder() {
  QHashSeed::resetRandomGlobalSeed();
}

std::string finished_pdf(const std::string& bytes, const PdfProperties& properties) {
  QPDF pdf;
  pdf.processMemoryFile("picture", bytes.data(), bytes.size());
  set_properties(pdf, properties);
  add_outline(pdf, properties.outline);
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setDeterministicID(true);
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.write();
  const std::shared_ptr<Buffer> result(writer.getBufferSharedPointer());
  return {reinterpret_cast<const char*>(result->getBuffer()), result->getSize()};
}

}  // namespace feedscope::ui
