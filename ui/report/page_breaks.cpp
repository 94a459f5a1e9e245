#include "ui/report/page_breaks.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>
#include <algorithm>
#include <cmath>

namespace feedscope::ui {

namespace {

int page_at(double place, double height) {
  return static_cast<int>(std::floor(place / height));
}

/// Where the first line of a block stands.
double first_line_bottom(const QTextDocument& document, const QTextBlock& block) {
  const double top = document.documentLayout()->blockBoundingRect(block).top();
  const QTextLayout& layout = *block.layout();
  return layout.lineCount() > 0 ? top + layout.lineAt(0).rect().bottom() : top;
}

bool is_heading(const QTextBlock& block) {
  return block.blockFormat().headingLevel() > 0;
}

QTextTable* table_of(const QTextBlock& block) {
  return block.isValid() ? QTextCursor(block).currentTable() : nullptr;
}

struct Extent {
  double top = 0;
  double bottom = 0;
};

Extent extent_of(const QTextDocument& document, QTextTable& table, int row) {
  Extent extent{1e12, 0};
  for (int column = 0; column < table.columns(); ++column) {
    const QTextTableCell cell = table.cellAt(row, column);
    const QTextBlock last = cell.lastCursorPosition().block();
    for (QTextBlock block = cell.firstCursorPosition().block(); block.isValid(); block = block.next()) {
      const QRectF place = document.documentLayout()->blockBoundingRect(block);
      extent = {std::min(extent.top, place.top()), std::max(extent.bottom, place.bottom())};
      if (block == last) {
        break;
      }
    }
  }
  return extent;
}

/// Lower end of what shows that a heading is not alone: of the first row of a table below its heads, or of
/// the first line of a text; a negative place where nothing follows.
double followed_until(const QTextDocument& document, const QTextBlock& heading) {
  QTextBlock block = heading.next();
  while (block.isValid() && is_heading(block)) {
    block = block.next();
  }
  if (!block.isValid()) {
    return -1;
  }
  const QTextBlock lead = block;
  if (table_of(block) == nullptr && table_of(block.next()) != nullptr) {
    block = block.next();  // a sentence above a table belongs to it
  }
  if (QTextTable* table = table_of(block)) {
    return extent_of(document, *table, std::min(table->format().headerRowCount(), table->rows() - 1)).bottom;
  }
  return first_line_bottom(document, lead);
}

void break_before(const QTextBlock& block) {
  QTextBlockFormat format = block.blockFormat();
  format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
  QTextCursor(block).setBlockFormat(format);
}

void keep_heading(const QTextDocument& document, const QTextBlock& heading, double height) {
  const double until = followed_until(document, heading);
  const double top = document.documentLayout()->blockBoundingRect(heading).top();
  if (until > 0 && top > 0 && page_at(top, height) != page_at(until - 1, height) &&
      until - top < 0.9 * height) {
    break_before(heading);
  }
}

void pad(QTextTable& table, int row, double padding) {
  for (int column = 0; column < table.columns(); ++column) {
    QTextTableCell cell = table.cellAt(row, column);
    QTextTableCellFormat format = cell.format().toTableCellFormat();
    format.setTopPadding(padding);
    cell.setFormat(format);
  }
}

/// Moves a row that a page's end would cut to the next page: QTextDocument breaks pages between the lines of
/// cells, so that room above them moves them all.
void keep_row(const QTextDocument& document, QTextTable& table, int row, double height) {
  const Extent extent = extent_of(document, table, row);
  const double end = (page_at(extent.top, height) + 1) * height;
  if (extent.bottom <= end + 0.5 || extent.bottom - extent.top > 0.8 * height) {
    return;
  }
  if (row == table.format().headerRowCount()) {
    QTextTableFormat format = table.format();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);  // heads and all
    table.setFormat(format);
    return;
  }
  const double before = table.cellAt(row, 0).format().toTableCellFormat().topPadding();
  const double usual = std::max(before, table.format().cellPadding());
  for (const double share : {0.1, 0.3, 0.6, 1.0}) {  // as little as does: it stays above the row
    pad(table, row, usual + share * (end - extent.top));
    const Extent now = extent_of(document, table, row);
    if (page_at(now.top, height) == page_at(now.bottom - 0.5, height)) {
      return;
    }
  }
}

void keep_all(const QTextDocument& document, double height) {
  bool after_heading = false;
  const QTextTable* done = nullptr;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    if (is_heading(block) && !after_heading) {
      keep_heading(document, block, height);
    }
    after_heading = is_heading(block);
    QTextTable* table = table_of(block);
    if (table != nullptr && table != done) {
      for (int row = table->format().headerRowCount(); row < table->rows(); ++row) {
        keep_row(document, *table, row, height);
      }
    }
    done = table;
  }
}

}  // namespace

void keep_together(QTextDocument& document, double height) {
  constexpr int passes = 2;  // laid out as a whole, places differ a little from those laid out in parts
  for (int pass = 0; pass < passes; ++pass) {
    keep_all(document, height);
    document.markContentsDirty(0, document.characterCount());  // painting would leave gaps between the parts
  }
}

}  // namespace feedscope::ui
