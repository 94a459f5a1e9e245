#include "ui/report/paged_document.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextObjectInterface>
#include <QTextTable>
#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <utility>

#include "ui/language/whole_units.h"
#include "ui/report/template_pictures.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

/// Type of an invisible character at the end of a block: when it is drawn, the whole block has been.
constexpr int end_object = QTextFormat::UserObject + 1;
constexpr int block_tag = QTextFormat::UserProperty + 1;   ///< of that character, and of a picture
constexpr int figure_tag = QTextFormat::UserProperty + 2;  ///< of a picture

/// Assigns tags to the blocks and pictures of a document.
class Tagger {
 public:
  Tagger(QTextDocument& document, const ReportPictures& pictures) : cursor_(&document), pictures_(pictures) {}

  std::vector<PdfTag> tag() {
    cursor_.beginEditBlock();
    for (QTextBlock block = cursor_.document()->begin(); block.isValid(); block = block.next()) {
      tag_block(block);
    }
    cursor_.endEditBlock();
    return std::move(tags_);
  }

 private:
  void tag_block(const QTextBlock& block) {
    const QString text = block.text().remove(QChar::ObjectReplacementCharacter).trimmed();
    const std::size_t own = text.isEmpty() ? tags_.size() : tag_of(block);
    for (const auto& [position, name] : pictures_in(block)) {
      QTextCharFormat format;
      format.setProperty(block_tag, static_cast<qulonglong>(own));
      format.setProperty(figure_tag, static_cast<qulonglong>(tags_.size()));
      tags_.push_back({QStringLiteral("Figure"), pictures_.description(name.section(':', 1))});
      select(position, position + 1);
      cursor_.mergeCharFormat(format);
    }
    if (!text.isEmpty()) {
      QTextCharFormat end;
      end.setObjectType(end_object);
      end.setProperty(block_tag, static_cast<qulonglong>(own));
      const int last = block.position() + block.length() - 1;
      select(last, last);
      cursor_.insertText(QString(QChar::ObjectReplacementCharacter), end);
    }
  }

  static std::vector<std::pair<int, QString>> pictures_in(const QTextBlock& block) {
    std::vector<std::pair<int, QString>> found;
    for (QTextBlock::iterator at = block.begin(); !at.atEnd(); ++at) {
      if (at.fragment().charFormat().isImageFormat()) {
        found.emplace_back(at.fragment().position(), at.fragment().charFormat().toImageFormat().name());
      }
    }
    return found;
  }

  void select(int from, int to) {
    cursor_.setPosition(from);
    cursor_.setPosition(to, QTextCursor::KeepAnchor);
  }

  /// Tables without a head only arrange other content.
  std::size_t tag_of(const QTextBlock& block) {
    cursor_.setPosition(block.position());
    const QTextTable* const table = cursor_.currentTable();
    if (table == nullptr || table->format().headerRowCount() == 0) {
      const int level = block.blockFormat().headingLevel();
      tags_.push_back({level > 0 ? QStringLiteral("H%1").arg(level) : QStringLiteral("P")});
      return tags_.size() - 1;
    }
    const QTextTableCell cell = table->cellAt(block.position());
    if (table != table_) {
      table_ = table;
      cell_ = -1;
      ++tables_;
    }
    if (cell.firstPosition() != cell_ || tags_.back().type == QStringLiteral("Figure")) {
      const bool head = cell.row() < table->format().headerRowCount();
      tags_.push_back({head ? QStringLiteral("TH") : QStringLiteral("TD"), {}, tables_, cell.row() + 1});
      cell_ = cell.firstPosition();
    }
    return tags_.size() - 1;
  }

  QTextCursor cursor_;
  const ReportPictures& pictures_;
  std::vector<PdfTag> tags_;
  const QTextTable* table_ = nullptr;
  int tables_ = 0;
  int cell_ = -1;  // first position of the last cell
};

}  // namespace

/// Draws pictures of the report in the text.
class PagedDocument::Pictures : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  Pictures(const ReportPictures& pictures, double largest_height, double raster_ratio)
      : pictures_(pictures), largest_height_(largest_height), raster_ratio_(raster_ratio) {}

  QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat& format) override {
    if (format.objectType() == end_object) {
      return {0, 0};
    }
    const QTextImageFormat image = format.toImageFormat();
    QSizeF size(image.width(), image.height());
    const InlinePicture* inside = inside_of(image.name());
    if (inside != nullptr && !(size.width() > 0 && size.height() > 0)) {
      const double scale = size.width() > 0    ? size.width() / inside->size().width()
                           : size.height() > 0 ? size.height() / inside->size().height()
                                               : 1;
      size = inside->size() * scale;
    }
    const double fitted = std::min({1.0, report_width / size.width(), largest_height_ / size.height()});
    return fitted < 1 ? size * fitted : size;
  }
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int,
                  const QTextFormat& format) override {
    if (format.objectType() == end_object) {
      mark_tag(*painter, format.property(block_tag).toULongLong());
      return;
    }
    const bool touches_only = place.intersected(page_).height() < 1;
    if (failure_ || touches_only) {
      return;
    }
    if (format.hasProperty(block_tag)) {
      mark_tag(*painter, format.property(block_tag).toULongLong());
    }
    draw_picture(painter, place, format.toImageFormat().name());
    if (format.hasProperty(figure_tag)) {
      mark_tag(*painter, format.property(figure_tag).toULongLong());
    }
  }

  const ReportPictures& all() const { return pictures_; }
  /// The part of the text that is being drawn: QTextDocument also draws parts that only touch it.
  void set_page(const QRectF& page) { page_ = page; }
  /// Rethrows an exception of painting a picture.
  void check() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  void draw_picture(QPainter* painter, const QRectF& place, const QString& name) {
    if (const InlinePicture* inside = inside_of(name)) {
      inside->draw(*painter, place);
      return;
    }
    const auto found = pictures_.all().find(name.section(':', 1));
    if (found == pictures_.all().end()) {
      return;
    }
    painter->save();
    painter->translate(place.topLeft());
    painter->setClipRect(QRectF(QPointF(), found->second.size), Qt::IntersectClip);
    try {
      pictures_.paint(found->first, *painter, raster_ratio_);
    } catch (...) {
      failure_ = std::current_exception();  // QTextDocument does not pass exceptions on
    }
    painter->restore();
  }

  const InlinePicture* inside_of(const QString& name) {
    if (!name.startsWith(QStringLiteral("data:"))) {
      return nullptr;
    }
    auto found = inside_.find(name);
    if (found == inside_.end()) {
      found = inside_.emplace(name, InlinePicture::from_url(name)).first;
    }
    return found->second ? &*found->second : nullptr;
  }

  const ReportPictures& pictures_;
  double largest_height_;
  double raster_ratio_;
  std::map<QString, std::optional<InlinePicture>> inside_;
  QRectF page_;
  std::exception_ptr failure_;
};

void set_on_paper(QTextDocument& document, QString html) {
  document.setDefaultFont(paper_font(11));
  document.setUseDesignMetrics(true);
  document.setDocumentMargin(0);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  document.setDefaultTextOption(option);
  document.setHtml(
      with_whole_units(std::move(html)).replace(QStringLiteral("<wbr>"), QStringLiteral("&#8203;")));
  document.setTextWidth(report_width);
}

PagedDocument::PagedDocument(QString html, const ReportPictures& pictures, const Paper& paper,
                             double raster_ratio)
    : pictures_(std::make_unique<Pictures>(pictures, paper.contents_height(), raster_ratio)) {
  document_.documentLayout()->registerHandler(QTextFormat::ImageObject, pictures_.get());
  document_.documentLayout()->registerHandler(end_object, pictures_.get());
  set_on_paper(document_, std::move(html));
  parts_ = page_parts(document_, paper.contents_height());
}

PagedDocument::~PagedDocument() = default;

std::vector<PdfTag> PagedDocument::add_tags() {
  const QSizeF size = document_.size();
  std::vector<PdfTag> tags = Tagger(document_, pictures_->all()).tag();
  if (document_.size() != size) {
    document_.undo();
    return {};
  }
  return tags;
}

PagedDocument::Place PagedDocument::place_of(double top) const {
  constexpr double rounding = 0.5;
  const auto next = std::ranges::upper_bound(parts_, top + rounding, {}, &PagePart::top);
  const auto found = next == parts_.begin() ? next : std::prev(next);
  return {static_cast<int>(found - parts_.begin()), found->head() + std::max(0.0, top - found->top)};
}

void PagedDocument::draw_part(QPainter& painter, double from, double to, double at) {
  const QRectF part(0, from, report_width, to - from);
  pictures_->set_page(part);
  painter.save();
  painter.translate(0, at - from);
  painter.setClipRect(part);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = part;
  context.palette.setColor(QPalette::Text, Qt::black);
  document_.documentLayout()->draw(&painter, context);
  painter.restore();
  pictures_->check();
}

void PagedDocument::draw(QPainter& painter, int page) {
  const PagePart& part = parts_[static_cast<std::size_t>(page)];
  if (part.head() > 0) {
    draw_part(painter, part.head_top, part.head_bottom, 0);
  }
  if (part.bottom > part.top) {
    draw_part(painter, part.top, part.clip_bottom, part.head());
  }
}

}  // namespace feedscope::ui

#include "paged_document.moc"
