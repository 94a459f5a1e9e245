#include "ui/report/paged_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <vector>

#include "ui/language/language.h"
#include "ui/report/paged_document.h"
#include "ui/report/pdf_file.h"
#include "ui/report/picture_file.h"
#include "ui/report/report_numbers.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

// A4 in units of 1/96 inch.
constexpr double page_width = 210 / 25.4 * 96;
constexpr double margin_side = (page_width - report_width) / 2;
constexpr double margin_top = page_margin_top;
constexpr double margin_bottom = page_margin_bottom;
constexpr int page_resolution = 1200;
constexpr double points_a_unit = 0.75;

void draw_margins(QPainter& painter, const PageTexts& texts, int page, int pages) {
  const QFont font = paper_font(9);
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
    line(margin_top - 30, texts.title, date_text(texts.date));
  }
  line(page_height - margin_bottom + 22,
       QStringLiteral("Feedscope %1").arg(QStringLiteral(FEEDSCOPE_VERSION)) +
           (texts.note.isEmpty() ? QString() : QStringLiteral(" · ") + texts.note),
       texts.number.arg(page + 1).arg(pages));
  painter.setPen(QPen(QColor(0xc8, 0xcd, 0xd2), 0.6));
  const double rule = page_height - margin_bottom + 16;
  painter.drawLine(QPointF(margin_side, rule), QPointF(margin_side + report_width, rule));
}

/// A page with its margins, its upper left corner at 0, 0 [1/96 inch].
void draw_page(QPainter& painter, PagedDocument& document, const PageTexts& texts, int page) {
  painter.save();
  painter.translate(margin_side, margin_top);
  document.draw(painter, page);
  painter.restore();
  draw_margins(painter, texts, page, static_cast<int>(document.pages().size()));
}

std::vector<PdfBookmark> bookmarks_of(const PagedDocument& document) {
  std::vector<PdfBookmark> bookmarks;
  const QTextDocument& text = document.text();
  for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
    const int level = block.blockFormat().headingLevel();
    if (level > 0 && !block.text().trimmed().isEmpty()) {
      const auto place = document.place_of(text.documentLayout()->blockBoundingRect(block).top());
      bookmarks.push_back({level, block.text().remove(QChar(0x200b)).simplified(), place.page,
                           (margin_top + place.top - 6) * points_a_unit});
    }
  }
  return bookmarks;
}

}  // namespace

std::string paged_pdf(const QString& html, const ReportPictures& pictures, const PageTexts& texts) {
  const StableOrder order;
  PagedDocument document(html, pictures);
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(page_resolution);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins({});
  QPainter painter(&writer);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                         QPainter::LosslessImageRendering);
  constexpr double unit = page_resolution / 96.0;
  painter.scale(unit, unit);
  const int pages = static_cast<int>(document.pages().size());
  for (int page = 0; page < pages; ++page) {
    if (page > 0) {
      writer.newPage();
    }
    draw_page(painter, document, texts, page);
  }
  painter.end();
  const QString date =
      texts.date.isValid() ? texts.date.toUTC().toString(QStringLiteral("'D:'yyyyMMddHHmmss'Z'")) : QString();
  return finished_pdf(buffer.data().toStdString(),
                      {texts.title, texts.author, date, bookmarks_of(document), spoken_language()});
}

RecordedPages recorded_pages(const QString& html, const ReportPictures& pictures, const PageTexts& texts) {
  constexpr QSizeF a4(210, 297);  // [mm]
  PagedDocument document(html, pictures);
  RecordedPages pages(texts.title, a4);
  for (int page = 0; page < static_cast<int>(document.pages().size()); ++page) {
    pages.add({page_width, page_height},
              [&](QPainter& painter) { draw_page(painter, document, texts, page); });
  }
  return pages;
}

std::vector<std::string> paged_pictures(const QString& html, const ReportPictures& pictures,
                                        const PageTexts& texts, double dpi) {
  constexpr double units_an_inch = 96;
  const double scale = dpi / units_an_inch;
  PagedDocument document(html, pictures, scale);
  std::vector<std::string> files;
  for (int page = 0; page < static_cast<int>(document.pages().size()); ++page) {
    PictureSpec spec;
    spec.size = QSizeF(page_width, page_height);
    spec.scale = scale;
    spec.title = texts.title;
    files.push_back(
        make_picture(spec, [&](QPainter& painter) { draw_page(painter, document, texts, page); }));
  }
  return files;
}

}  // namespace feedscope::ui
