#include "ui/paper/pdf_tags.h"

#include <fmt/format.h>

#include <QPainter>
#include <charconv>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <string>
#include <string_view>

namespace feedscope::ui {

namespace {

constexpr int mark_column = -77777;  // x of marks; their y is -1 less the number of the tag
constexpr std::string_view mark_tail = " 1 1 re\nf\n";

/// A mark in the contents of a page.
struct TagMark {
  std::size_t begin = 0;  ///< of its text
  std::size_t end = 0;
  std::size_t tag = 0;
};

std::vector<TagMark> marks_in(std::string_view contents) {
  const std::string head = fmt::format("{} -", mark_column);
  std::vector<TagMark> marks;
  for (std::size_t at = contents.find(head); at != std::string_view::npos; at = contents.find(head, at + 1)) {
    const char* const number = contents.data() + at + head.size();
    std::size_t place = 0;
    const auto [after, error] = std::from_chars(number, contents.data() + contents.size(), place);
    const auto tail = static_cast<std::size_t>(after - contents.data());
    if (error == std::errc() && place > 0 && contents.substr(tail, mark_tail.size()) == mark_tail) {
      marks.push_back({at, tail + mark_tail.size(), place - 1});
    }
  }
  return marks;
}

/// The structure of a document under construction.
class TagTree {
 public:
  TagTree(QPDF& pdf, const std::vector<PdfTag>& tags) : pdf_(pdf), tags_(tags), elements_(tags.size()) {
    root_ = element("StructTreeRoot", {});
    root_.replaceKey("/Type", name("StructTreeRoot"));
    root_.removeKey("/S");
    root_.removeKey("/P");
    document_ = element("Document", root_);
  }

  /// Returns the number of the piece on its page.
  int add(std::size_t tag, const QPDFObjectHandle& page, QPDFObjectHandle& parents) {
    QPDFObjectHandle& owner = element_of(tag);
    const int number = parents.getArrayNItems();
    QPDFObjectHandle piece = QPDFObjectHandle::newDictionary();
    piece.replaceKey("/Type", name("MCR"));
    piece.replaceKey("/Pg", page);
    piece.replaceKey("/MCID", QPDFObjectHandle::newInteger(number));
    owner.getKey("/K").appendItem(piece);
    parents.appendItem(owner);
    return number;
  }

  void add_page(QPDFObjectHandle page, const QPDFObjectHandle& parents) {
    page.replaceKey("/StructParents", QPDFObjectHandle::newInteger(pages_));
    page.replaceKey("/Tabs", name("S"));
    page_parents_.appendItem(QPDFObjectHandle::newInteger(pages_++));
    page_parents_.appendItem(pdf_.makeIndirectObject(parents));
  }

  void finish() {
    QPDFObjectHandle numbers = QPDFObjectHandle::newDictionary();
    numbers.replaceKey("/Nums", page_parents_);
    root_.replaceKey("/ParentTree", pdf_.makeIndirectObject(numbers));
    root_.replaceKey("/ParentTreeNextKey", QPDFObjectHandle::newInteger(pages_));
    QPDFObjectHandle marked = QPDFObjectHandle::newDictionary();
    marked.replaceKey("/Marked", QPDFObjectHandle::newBool(true));
    pdf_.getRoot().replaceKey("/MarkInfo", marked);
    pdf_.getRoot().replaceKey("/StructTreeRoot", root_);
  }

 private:
  static QPDFObjectHandle name(const std::string& text) { return QPDFObjectHandle::newName("/" + text); }

  /// Appends a part to `parent`.
  QPDFObjectHandle element(const std::string& type, QPDFObjectHandle parent) {
    QPDFObjectHandle made = pdf_.makeIndirectObject(QPDFObjectHandle::newDictionary());
    made.replaceKey("/Type", name("StructElem"));
    made.replaceKey("/S", name(type));
    made.replaceKey("/K", QPDFObjectHandle::newArray());
    if (parent.isInitialized()) {
      made.replaceKey("/P", parent);
      parent.getKey("/K").appendItem(made);
    }
    return made;
  }

  /// Row of a table, created at its first cell.
  QPDFObjectHandle row_of(const PdfTag& tag) {
    if (tag.table != table_number_) {
      table_ = element("Table", document_);
      table_number_ = tag.table;
      row_number_ = -1;
    }
    if (tag.row != row_number_) {
      row_ = element("TR", table_);
      row_number_ = tag.row;
    }
    return row_;
  }

  QPDFObjectHandle& element_of(std::size_t i) {
    while (made_ <= i) {  // in document order, whatever the order of painting
      const PdfTag& tag = tags_[made_];
      QPDFObjectHandle& made = elements_[made_++];
      made = element(tag.type.toStdString(), tag.table > 0 ? row_of(tag) : document_);
      if (!tag.alternative.isEmpty()) {
        made.replaceKey("/Alt", QPDFObjectHandle::newUnicodeString(tag.alternative.toStdString()));
      }
    }
    return elements_[i];
  }

  QPDF& pdf_;
  const std::vector<PdfTag>& tags_;
  std::vector<QPDFObjectHandle> elements_;  // of tags_, those before made_
  std::size_t made_ = 0;
  QPDFObjectHandle root_;
  QPDFObjectHandle document_;
  QPDFObjectHandle table_;
  QPDFObjectHandle row_;
  int table_number_ = 0;
  int row_number_ = -1;
  QPDFObjectHandle page_parents_ = QPDFObjectHandle::newArray();
  int pages_ = 0;
};

/// The contents of a page with its marks turned into marked contents: the part between two marks belongs to
/// the tag of the second.
std::string with_marked_contents(std::string_view contents, const std::vector<PdfTag>& tags, TagTree& tree,
                                 const QPDFObjectHandle& page, QPDFObjectHandle& parents) {
  std::string made;
  made.reserve(contents.size() + 1000);
  std::size_t from = 0;
  for (const TagMark& mark : marks_in(contents)) {
    made += fmt::format("/{} <</MCID {}>> BDC\n", tags[mark.tag].type.toStdString(),
                        tree.add(mark.tag, page, parents));
    made += contents.substr(from, mark.begin - from);
    made += "EMC\n";
    from = mark.end;
  }
  return made.append("/Artifact BMC\n").append(contents.substr(from)).append("EMC\n");
}

}  // namespace

void mark_tag(QPainter& painter, std::size_t tag) {
  painter.save();
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::black);
  painter.drawRect(QRectF(mark_column, -1 - static_cast<double>(tag), 1, 1));
  painter.restore();
}

void add_tags(QPDF& pdf, const std::vector<PdfTag>& tags) {
  if (tags.empty()) {
    return;
  }
  TagTree tree(pdf, tags);
  for (QPDFPageObjectHelper& helper : QPDFPageDocumentHelper(pdf).getAllPages()) {
    QPDFObjectHandle page = helper.getObjectHandle();
    QPDFObjectHandle contents = page.getKey("/Contents");
    const auto bytes = contents.getStreamData(qpdf_dl_generalized);
    QPDFObjectHandle parents = QPDFObjectHandle::newArray();
    const std::string_view text(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize());
    contents.replaceStreamData(with_marked_contents(text, tags, tree, page, parents),
                               QPDFObjectHandle::newNull(), QPDFObjectHandle::newNull());
    tree.add_page(page, parents);
  }
  tree.finish();
}

}  // namespace feedscope::ui
