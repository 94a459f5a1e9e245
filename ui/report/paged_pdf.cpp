#include "ui/report/paged_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <algorithm>
#include <optional>
#include <vector>

#include "ui/language/language.h"
#include "ui/paper/pdf_file.h"
#include "ui/paper/picture_file.h"
#include "ui/report/paged_document.h"
#include "ui/report/report_numbers.h"
#include "ui/theme/fonts.h"

namespace feedscope::ui {

namespace {

constexpr int page_resolution = 1200;
constexpr double points_a_unit = 0.75;

double margin_side(const Paper& paper) {
  return (paper.width - report_width) / 2;
}

QSizeF sheet_millimetres(const Paper& paper) {
  constexpr double units_a_millimetre = 96 / 25.4;
  return QSizeF(paper.width, paper.height) / units_a_millimetre;
}

void draw_margins(QPainter& painter, const PageTexts& texts, int page, int pages) {
  const QFont font = paper_font(9);
  painter.setFont(font);
  painter.setPen(QColor(0x6a, 0x70, 0x78));
  const QFontMetricsF metrics(font);
  const double side = margin_side(texts.paper);
  const auto line = [&](double top, const QString& left, const QString& right) {
    const QRectF room(side, top, report_width, metrics.height());
    const double used = metrics.horizontalAdvance(right) + 20;
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(left, Qt::ElideMiddle, report_width - used));
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, right);
  };
  if (page > 0) {
    line(Paper::margin_top - 30, texts.title, date_text(texts.date));
  }
  line(texts.paper.height - Paper::margin_bottom + 22,
       QStringLiteral("Feedscope %1").arg(QStringLiteral(FEEDSCOPE_VERSION)) +
           (texts.note.isEmpty() ? QString() : QStringLiteral(" · ") + texts.note),
       texts.number.arg(page + 1).arg(pages));
  painter.setPen(QPen(QColor(0xc8, 0xcd, 0xd2), 0.6));
  const double rule = texts.paper.height - Paper::margin_bottom + 16;
  painter.drawLine(QPointF(side, rule), QPointF(side + report_width, rule));
}

/// Draws a page with its margins, its upper left corner at 0, 0 [1/96 inch].
void draw_page(QPainter& painter, PagedDocument& document, const PageTexts& texts, int page) {
  painter.save();
  painter.translate(margin_side(texts.paper), Paper::margin_top);
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
      bookmarks.push_back(
          {level, block.text().remove(QChar(0x200b)).remove(QChar::ObjectReplacementCharacter).simplified(),
           place.page, (Paper::margin_top + place.top - 6) * points_a_unit});
    }
  }
  return bookmarks;
}

/// Calls `visit` with each fragment that is an anchor, its block, and its first and last position there.
template <class Visit>
void for_each_anchor(const QTextDocument& text, Visit visit) {
  for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
    for (QTextBlock::iterator at = block.begin(); !at.atEnd(); ++at) {
      const QTextFragment fragment = at.fragment();
      if (fragment.isValid() && fragment.charFormat().isAnchor()) {
        const int from = fragment.position() - block.position();
        visit(fragment, block, from, from + fragment.length());
      }
    }
  }
}

/// The lines of a block between two positions [1/96 inch of the document].
std::vector<QRectF> places_of(const QTextDocument& text, const QTextBlock& block, int from, int to) {
  const QTextLayout& layout = *block.layout();
  const QPointF origin =
      text.documentLayout()->blockBoundingRect(block).topLeft() - layout.boundingRect().topLeft();
  std::vector<QRectF> places;
  for (int i = 0; i < layout.lineCount(); ++i) {
    const QTextLine line = layout.lineAt(i);
    const int first = std::max(from, line.textStart());
    const int last = std::min(to, line.textStart() + line.textLength());
    if (first < last) {
      places.emplace_back(origin + QPointF(line.cursorToX(first), line.y()),
                          origin + QPointF(line.cursorToX(last), line.y() + line.height()));
    }
  }
  return places;
}

/// The top of the figure whose caption begins with this name and a full stop; the text does not keep names of
/// anchors.
std::optional<double> top_of_figure(const QTextDocument& text, const QString& name) {
  for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
    if (block.text().simplified().startsWith(name.simplified() + '.')) {
      const QTextBlock above = block.previous();
      const bool shows = above.isValid() && above.text().contains(QChar::ObjectReplacementCharacter);
      return text.documentLayout()->blockBoundingRect(shows ? above : block).top();
    }
  }
  return std::nullopt;
}

/// References to figures of the document.
std::vector<PdfLink> links_of(const PagedDocument& document, const Paper& paper) {
  const QTextDocument& text = document.text();
  std::vector<PdfLink> links;
  for_each_anchor(text, [&](const QTextFragment& fragment, const QTextBlock& block, int from, int to) {
    const std::optional<double> target = fragment.charFormat().anchorHref().startsWith('#')
                                             ? top_of_figure(text, fragment.text())
                                             : std::nullopt;
    if (!target) {
      return;
    }
    const auto leads = document.place_of(*target);
    for (const QRectF& place : places_of(text, block, from, to)) {
      const auto at = document.place_of(place.top());
      const QRectF area(margin_side(paper) + place.left(), Paper::margin_top + at.top, place.width(),
                        place.height());
      links.push_back({at.page, QRectF(area.topLeft() * points_a_unit, area.size() * points_a_unit),
                       fragment.text(), leads.page, std::max(0.0, leads.top) * points_a_unit});
    }
  });
  return links;
}

}  // namespace

std::string paged_pdf(const QString& html, const ReportPictures& pictures, const PageTexts& texts) {
  const StableOrder order;
  PagedDocument document(html, pictures, texts.paper);
  std::vector<PdfTag> tags = document.add_tags();
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(page_resolution);
  writer.setPageSize(QPageSize(sheet_millimetres(texts.paper), QPageSize::Millimeter));
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
                      {texts.title, texts.author, date, bookmarks_of(document), spoken_language(),
                       links_of(document, texts.paper), std::move(tags)});
}

RecordedPages recorded_pages(const QString& html, const ReportPictures& pictures, const PageTexts& texts) {
  PagedDocument document(html, pictures, texts.paper);
  RecordedPages pages(texts.title, sheet_millimetres(texts.paper));
  for (int page = 0; page < static_cast<int>(document.pages().size()); ++page) {
    pages.add({texts.paper.width, texts.paper.height},
              [&](QPainter& painter) { draw_page(painter, document, texts, page); });
  }
  return pages;
}

std::vector<std::string> paged_pictures(const QString& html, const ReportPictures& pictures,
                                        const PageTexts& texts, double dpi) {
  constexpr double units_an_inch = 96;
  const double scale = dpi / units_an_inch;
  PagedDocument document(html, pictures, texts.paper, scale);
  std::vector<std::string> files;
  for (int page = 0; page < static_cast<int>(document.pages().size()); ++page) {
    PictureSpec spec;
    spec.size = QSizeF(texts.paper.width, texts.paper.height);
    spec.scale = scale;
    spec.title = texts.title;
    files.push_back(
        make_picture(spec, [&](QPainter& painter) { draw_page(painter, document, texts, page); }));
  }
  return files;
}

}  // namespace feedscope::ui
