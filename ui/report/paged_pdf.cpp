#include "ui/report/paged_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextObjectInterface>
#include <cmath>
#include <exception>

#include "ui/report/page_breaks.h"
#include "ui/report/pdf_file.h"

namespace feedscope::ui {

namespace {

// A4 in units of 1/96 inch.
constexpr double page_width = 210 / 25.4 * 96;
constexpr double page_height = 297 / 25.4 * 96;
constexpr double margin_top = 62;
constexpr double margin_bottom = 60;
constexpr double margin_side = (page_width - report_width) / 2;
constexpr double contents_height = page_height - margin_top - margin_bottom;
constexpr int resolution = 1200;
constexpr double raster_ratio = 300.0 / 96;  // 300 dots an inch

/// Pictures of the report where the text has them.
class PictureHandler : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  explicit PictureHandler(const ReportPictures& pictures) : pictures_(pictures) {}

  QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat& format) override {
    const QTextImageFormat image = format.toImageFormat();
    return {image.width(), image.height()};
  }
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int,
                  const QTextFormat& format) override {
    const auto found = pictures_.all().find(format.toImageFormat().name().section(':', 1));
    const bool touches_only = place.intersected(page_).height() < 1;
    if (found == pictures_.all().end() || failure_ || touches_only) {
      return;
    }
    painter->save();
    painter->translate(place.topLeft());
    painter->setClipRect(QRectF(QPointF(), found->second.size), Qt::IntersectClip);
    try {
      pictures_.paint(found->first, *painter, raster_ratio);
    } catch (...) {
      failure_ = std::current_exception();  // QTextDocument passes no exceptions on
    }
    painter->restore();
  }

  /// The part of the text that is drawn now: QTextDocument draws what only touches it too.
  void set_page(const QRectF& page) { page_ = page; }
  /// Throws what painting a picture threw.
  void check() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  const ReportPictures& pictures_;
  QRectF page_;
  std::exception_ptr failure_;
};

QFont page_font() {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(11);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

void draw_margins(QPainter& painter, const PageTexts& texts, int page, int pages) {
  QFont font = page_font();
  font.setPixelSize(9);
  painter.setFont(font);
  painter.setPen(QColor(0x6a, 0x70, 0x78));
  const QFontMetricsF metrics(font);
  const auto line = [&](double top, const QString& left, const QString& right) {
    const QRectF room(margin_side, top, report_width, metrics.height());
    const double used = metrics.horizontalAdvance(right) + 20;
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(left, Qt::ElideMiddle, report_width - used));
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, right);
  };
  if (page > 0) {
    line(margin_top - 30, texts.title,
         texts.date.isValid() ? texts.date.toString(QStringLiteral("yyyy-MM-dd")) : QString());
  }
  line(page_height - margin_bottom + 22,
       QStringLiteral("Feedscope %1").arg(QStringLiteral(FEEDSCOPE_VERSION)),
       QStringLiteral("page %1 of %2").arg(page + 1).arg(pages));
  painter.setPen(QPen(QColor(0xc8, 0xcd, 0xd2), 0.6));
  const double rule = page_height - margin_bottom + 16;
  painter.drawLine(QPointF(margin_side, rule), QPointF(margin_side + report_width, rule));
}

QRectF part_of(int page) {
  return {0, page * contents_height, report_width, contents_height};
}

void draw_page(QPainter& painter, QTextDocument& document, const QRectF& part) {
  painter.save();
  painter.translate(margin_side, margin_top - part.top());
  painter.setClipRect(part);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = part;
  context.palette.setColor(QPalette::Text, Qt::black);
  document.documentLayout()->draw(&painter, context);
  painter.restore();
}

std::vector<PdfBookmark> bookmarks_of(const QTextDocument& document) {
  std::vector<PdfBookmark> bookmarks;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const int level = block.blockFormat().headingLevel();
    if (level > 0 && !block.text().trimmed().isEmpty()) {
      const double top = document.documentLayout()->blockBoundingRect(block).top();
      const int page = static_cast<int>(top / contents_height);
      const double on_page = margin_top + top - page * contents_height;
      bookmarks.push_back(
          {level, block.text().remove(QChar(0x200b)).simplified(), page, (on_page - 6) * 0.75});
    }
  }
  return bookmarks;
}

void fill(QTextDocument& document, PictureHandler& handler, QString html) {
  document.setDefaultFont(page_font());
  document.setUseDesignMetrics(true);
  document.setDocumentMargin(0);
  document.documentLayout()->registerHandler(QTextFormat::ImageObject, &handler);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  document.setDefaultTextOption(option);
  document.setHtml(html.replace(QStringLiteral("<wbr>"), QStringLiteral("&#8203;")));
  document.setPageSize({report_width, contents_height});
}

}  // namespace

std::string paged_pdf(const QString& html, const ReportPictures& pictures, const PageTexts& texts) {
  const StableOrder order;
  PictureHandler handler(pictures);
  QTextDocument document;
  fill(document, handler, html);
  keep_together(document, contents_height);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(resolution);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins({});
  QPainter painter(&writer);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                         QPainter::LosslessImageRendering);
  constexpr double unit = resolution / 96.0;
  painter.scale(unit, unit);
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page) {
    if (page > 0) {
      writer.newPage();
    }
    handler.set_page(part_of(page));
    draw_page(painter, document, part_of(page));
    handler.check();
    draw_margins(painter, texts, page, pages);
  }
  painter.end();
  const QString date =
      texts.date.isValid() ? texts.date.toUTC().toString(QStringLiteral("'D:'yyyyMMddHHmmss'Z'")) : QString();
  return finished_pdf(buffer.data().toStdString(), {texts.title, texts.author, date, bookmarks_of(document)});
}

}  // namespace feedscope::ui

#include "paged_pdf.moc"
