#include "ui/paper/pdf_file.h"

#include <fmt/format.h>

#include <QHashFunctions>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFTokenizer.hh>
#include <qpdf/QPDFWriter.hh>
#include <set>

namespace feedscope::ui {

namespace {

QPDFObjectHandle text_object(const QString& text) {
  return QPDFObjectHandle::newUnicodeString(text.toStdString());
}

using Pages = std::vector<QPDFPageObjectHelper>;

double height_of(const Pages& pages, int page) {
  QPDFPageObjectHelper helper = pages.at(static_cast<std::size_t>(page));
  return helper.getMediaBox().getArrayAsRectangle().ury;
}

/// Destination at `top` below the upper edge of a page, with unchanged zoom.
QPDFObjectHandle destination(const Pages& pages, int page, double top) {
  QPDFObjectHandle place = QPDFObjectHandle::newArray();
  place.appendItem(pages.at(static_cast<std::size_t>(page)).getObjectHandle());
  place.appendItem(QPDFObjectHandle::newName("/XYZ"));
  place.appendItem(QPDFObjectHandle::newNull());
  place.appendItem(QPDFObjectHandle::newReal(height_of(pages, page) - top, 2));
  place.appendItem(QPDFObjectHandle::newNull());
  return place;
}

/// One entry of the outline, not yet linked to its neighbours.
QPDFObjectHandle outline_item(QPDF& pdf, const PdfBookmark& bookmark, const Pages& pages) {
  QPDFObjectHandle item = pdf.makeIndirectObject(QPDFObjectHandle::newDictionary());
  item.replaceKey("/Title", text_object(bookmark.title));
  item.replaceKey("/Dest", destination(pages, bookmark.page, bookmark.top));
  return item;
}

QPDFObjectHandle link_object(QPDF& pdf, const PdfLink& link, const Pages& pages) {
  const double height = height_of(pages, link.page);
  QPDFObjectHandle object = pdf.makeIndirectObject(QPDFObjectHandle::newDictionary());
  object.replaceKey("/Type", QPDFObjectHandle::newName("/Annot"));
  object.replaceKey("/Subtype", QPDFObjectHandle::newName("/Link"));
  object.replaceKey("/Rect",
                    QPDFObjectHandle::newFromRectangle({link.area.left(), height - link.area.bottom(),
                                                        link.area.right(), height - link.area.top()}));
  QPDFObjectHandle no_border = QPDFObjectHandle::newArray();
  for (int i = 0; i < 3; ++i) {
    no_border.appendItem(QPDFObjectHandle::newInteger(0));
  }
  object.replaceKey("/Border", no_border);
  object.replaceKey("/Contents", text_object(link.title));
  object.replaceKey("/Dest", destination(pages, link.to_page, link.to_top));
  return object;
}

/// The annotations of a page without QPdfWriter's for references within the document, which it turns into
/// links to a file.
QPDFObjectHandle other_annotations(const QPDFPageObjectHelper& page) {
  QPDFObjectHandle all = QPDFPageObjectHelper(page).getObjectHandle().getKey("/Annots");
  QPDFObjectHandle kept = QPDFObjectHandle::newArray();
  for (int i = 0; all.isArray() && i < all.getArrayNItems(); ++i) {
    QPDFObjectHandle action = all.getArrayItem(i).getKey("/A");
    QPDFObjectHandle address = action.isDictionary() ? action.getKey("/URI") : QPDFObjectHandle::newNull();
    if (!address.isString() || !address.getStringValue().starts_with('#')) {
      kept.appendItem(all.getArrayItem(i));
    }
  }
  return kept;
}

void add_links(QPDF& pdf, const std::vector<PdfLink>& links) {
  const Pages pages = QPDFPageDocumentHelper(pdf).getAllPages();
  for (const QPDFPageObjectHelper& page : pages) {
    if (QPDFObjectHandle object = QPDFPageObjectHelper(page).getObjectHandle(); object.hasKey("/Annots")) {
      object.replaceKey("/Annots", other_annotations(page));
    }
  }
  for (const PdfLink& link : links) {
    QPDFObjectHandle page = pages.at(static_cast<std::size_t>(link.page)).getObjectHandle();
    QPDFObjectHandle annotations = page.getKey("/Annots");
    if (!annotations.isArray()) {
      annotations = QPDFObjectHandle::newArray();
    }
    annotations.appendItem(link_object(pdf, link, pages));
    page.replaceKey("/Annots", annotations);
  }
}

/// Links items into the tree of their levels; a skipped level counts as the next one.
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

  /// Closes a level; its items are collapsed initially.
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
  const Pages pages = QPDFPageDocumentHelper(pdf).getAllPages();
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
      "/ID");  // of Qt 6.8, different each time; the writer derives one from the contents
}

/// Rounds coordinates of paths to what a printer can show, and colours to what a screen can; QPdfWriter
/// writes nine figures of each.
class NumberRounding : public QPDFObjectHandle::TokenFilter {
 public:
  void handleToken(const QPDFTokenizer::Token& token) override {
    operands_.push_back(token);
    if (token.getType() == QPDFTokenizer::tt_word) {
      write_operation(token.getRawValue());
    }
  }

  void handleEOF() override { flush(std::nullopt); }

 private:
  static constexpr double visible = 0.01;  // [points]
  static constexpr int colour_decimals = 3;

  void write_operation(const std::string& name) {
    static const std::set<std::string> paths{"m", "l", "c", "v", "y", "re"};
    static const std::set<std::string> colours{"SCN", "scn", "RG", "rg"};
    if (name == "q") {
      scales_.push_back(scales_.back());
    } else if (name == "Q" && scales_.size() > 1) {
      scales_.pop_back();
    } else if (name == "cm") {
      scales_.back() *= largest_factor();
    }
    flush(paths.contains(name)     ? std::optional(path_decimals())
          : colours.contains(name) ? std::optional(colour_decimals)
                                   : std::nullopt);
  }

  /// Largest factor of the matrix whose numbers are the operands.
  double largest_factor() const {
    double largest = 0;
    int numbers = 0;
    for (const QPDFTokenizer::Token& token : operands_) {
      if (is_number(token) && ++numbers <= 4) {
        largest = std::max(largest, std::abs(std::stod(token.getValue())));
      }
    }
    return largest;
  }

  int path_decimals() const {
    int decimals = 0;
    for (double step = scales_.back(); step > visible && decimals < most_decimals; step /= 10) {
      ++decimals;
    }
    return decimals;
  }

  /// Writes the operation with its operands, those that are not whole with at most `decimals`.
  void flush(std::optional<int> decimals) {
    for (const QPDFTokenizer::Token& token : operands_) {
      if (decimals && token.getType() == QPDFTokenizer::tt_real) {
        write_number(std::stod(token.getValue()), *decimals);
      } else {
        writeToken(token);
      }
    }
    operands_.clear();
  }

  void write_number(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) {
      text.erase(text.find_last_not_of('0') + 1);
      text.erase(text.find_last_not_of('.') + 1);
    }
    TokenFilter::write(text == "-0" ? "0" : text);
  }

  static bool is_number(const QPDFTokenizer::Token& token) {
    return token.getType() == QPDFTokenizer::tt_real || token.getType() == QPDFTokenizer::tt_integer;
  }

  static constexpr int most_decimals = 9;
  std::vector<QPDFTokenizer::Token> operands_;  ///< since the last operation, with the blanks between
  std::vector<double> scales_{1};               ///< points a unit, of each saved state
};

void round_numbers(QPDF& pdf) {
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(pdf).getAllPages()) {
    page.addContentTokenFilter(std::make_shared<NumberRounding>());
  }
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
  add_links(pdf, properties.links);
  add_tags(pdf, properties.tags);
  round_numbers(pdf);
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setDeterministicID(true);
  writer.setObjectStreamMode(qpdf_o_generate);
  writer.write();
  const std::shared_ptr<Buffer> result(writer.getBufferSharedPointer());
  return {reinterpret_cast<const char*>(result->getBuffer()), result->getSize()};
}

}  // namespace feedscope::ui
