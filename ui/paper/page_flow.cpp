#include "ui/paper/page_flow.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextList>
#include <QTextTable>
#include <algorithm>
#include <cmath>

#include "ui/paper/page_breaks.h"

namespace feedscope::ui {

namespace {

// Costs of breaks within parts that belong together.
constexpr double heading_cost = 1e7;
constexpr double row_cost = 3e6;
constexpr double table_cost = 1e6;
constexpr double lead_cost = 2e4;    // a sentence and the table, list or section after it
constexpr double orphan_cost = 120;  // a single line of a paragraph, or a single row of a table
constexpr double paragraph_cost = 8;

constexpr double rounding = 0.5;
constexpr double border = 5;  // and space above it, below the last row of a table

struct Extent {
  double top = 1e12;
  double bottom = -1;

  bool empty() const { return bottom < top; }
  double height() const { return bottom - top; }
  void add(const Extent& other) {
    top = std::min(top, other.top);
    bottom = std::max(bottom, other.bottom);
  }
};

/// A part that should stay on one page.
struct Hold {
  Extent extent;
  double cost = 0;
};

/// A part of the text or of a cell, in order.
struct Item {
  enum class Kind { heading, text, note, table };
  Kind kind = Kind::text;
  Extent whole;
  double first_until = 0;  ///< lower end of the lines that must stay with the part above
  double last_from = 0;    ///< upper end of the lines that must stay with the part below
  bool in_list = false;

  /// A few lines, which are never divided.
  bool is_short() const { return first_until >= whole.bottom; }
};

/// Heads of a table, and the range of rows in which they are repeated.
struct Heads {
  Extent heads;
  Extent rows;
};

class FlowReader {
 public:
  FlowReader(const QTextDocument& document, double height)
      : document_(document), layout_(*document.documentLayout()), height_(height) {
    read(document.rootFrame()->begin());
  }

  std::vector<PagePart> parts();

 private:
  void read(QTextFrame::iterator it);
  void read_block(const QTextBlock& block, std::vector<Item>& items);
  Item read_table(QTextTable& table);
  Extent read_cell(const QTextTableCell& cell);
  void hold_table(const std::vector<Extent>& rows, int heads, bool figures);
  void hold_items(const std::vector<Item>& items);
  void hold(double top, double bottom, double cost) {
    if (bottom - top <= height_) {
      holds_.push_back({{top, bottom}, cost});
    }
  }

  std::vector<PageGap> gaps() const;
  void weigh(std::vector<PageGap>& gaps) const;
  const Heads* heads_at(double place) const;

  const QTextDocument& document_;
  const QAbstractTextDocumentLayout& layout_;
  double height_;
  std::vector<Extent> lines_;
  std::vector<Hold> holds_;
  std::vector<double> edges_;    ///< between rows of tables
  std::vector<double> tops_;     ///< of tables
  std::vector<double> bottoms_;  ///< of tables
  std::vector<double> forced_;   ///< a page begins below them
  std::vector<Heads> heads_;
};

bool asks_for_page(const QTextFormat& format) {
  return (format.intProperty(QTextFormat::PageBreakPolicy) & QTextFormat::PageBreak_AlwaysBefore) != 0;
}

bool has_image(const QTextTableCell& cell) {
  const int last = cell.lastCursorPosition().block().blockNumber();
  for (QTextBlock block = cell.firstCursorPosition().block(); block.isValid() && block.blockNumber() <= last;
       block = block.next()) {
    if (block.text().contains(QChar::ObjectReplacementCharacter)) {
      return true;
    }
  }
  return false;
}

/// A picture with its caption, or several.
bool is_figures(const QTextTable& table) {
  for (int row = 0; row < table.rows(); ++row) {
    if (has_image(table.cellAt(row, 0))) {
      return true;
    }
  }
  return false;
}

void FlowReader::read(QTextFrame::iterator it) {
  std::vector<Item> items;
  for (; !it.atEnd(); ++it) {
    if (auto* table = qobject_cast<QTextTable*>(it.currentFrame())) {
      items.push_back(read_table(*table));
    } else if (it.currentFrame() != nullptr) {
      read(it.currentFrame()->begin());
    } else {
      read_block(it.currentBlock(), items);
    }
  }
  hold_items(items);
}

void FlowReader::read_block(const QTextBlock& block, std::vector<Item>& items) {
  if (block.text().isEmpty()) {
    return;  // QTextDocument puts such blocks around tables
  }
  const QPointF corner = layout_.blockBoundingRect(block).topLeft();
  const QTextLayout& text = *block.layout();
  std::vector<Extent> lines;
  for (int i = 0; i < text.lineCount(); ++i) {
    const QRectF line = text.lineAt(i).rect();
    lines.push_back({corner.y() + line.top(), corner.y() + line.bottom()});
  }
  if (lines.empty()) {
    return;
  }
  for (const Extent& line : lines) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(line.height() / height_ - 1e-9)));
    for (int i = 0; i < pieces; ++i) {  // of a picture too high for any page
      lines_.push_back({line.top + i * line.height() / pieces, line.top + (i + 1) * line.height() / pieces});
    }
  }
  Item item;
  item.whole = {lines.front().top, lines.back().bottom};
  const bool heading = block.blockFormat().headingLevel() > 0;
  const int size = block.begin().fragment().charFormat().intProperty(QTextFormat::FontPixelSize);
  const bool small = size > 0 && size < document_.defaultFont().pixelSize();
  item.kind = heading ? Item::Kind::heading : small ? Item::Kind::note : Item::Kind::text;
  const std::size_t kept = lines.size() <= 3 ? lines.size() : 2;
  item.first_until = lines[kept - 1].bottom;
  item.last_from = lines[lines.size() - kept].top;
  item.in_list = block.textList() != nullptr;
  hold(item.whole.top, item.first_until, heading ? heading_cost : orphan_cost);
  hold(item.last_from, item.whole.bottom, heading ? heading_cost : orphan_cost);
  hold(item.whole.top, item.whole.bottom, heading ? heading_cost : paragraph_cost);
  if (asks_for_page(block.blockFormat())) {
    forced_.push_back(item.whole.top);
  }
  items.push_back(item);
}

Extent FlowReader::read_cell(const QTextTableCell& cell) {
  const std::size_t first = lines_.size();
  read(cell.begin());
  Extent extent;
  for (std::size_t i = first; i < lines_.size(); ++i) {
    extent.add(lines_[i]);
  }
  if (extent.empty()) {
    const QRectF place = layout_.blockBoundingRect(cell.firstCursorPosition().block());
    extent = {place.top(), place.bottom()};
    lines_.push_back(extent);
  }
  return extent;
}

Item FlowReader::read_table(QTextTable& table) {
  std::vector<Extent> rows(static_cast<std::size_t>(table.rows()));
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < table.columns(); ++column) {
      const QTextTableCell cell = table.cellAt(row, column);
      if (cell.row() == row && cell.column() == column) {
        rows[static_cast<std::size_t>(row)].add(read_cell(cell));
      }
    }
  }
  for (std::size_t row = 1; row < rows.size(); ++row) {
    if (rows[row].empty()) {  // its cells all belong to the row above
      rows[row] = {rows[row - 1].bottom, rows[row - 1].bottom};
    }
  }
  const double padding = table.format().cellPadding() + 1;
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    edges_.push_back((rows[row].bottom + rows[row + 1].top) / 2);
  }
  tops_.push_back(rows.front().top - padding);
  const double frame = layout_.frameBoundingRect(&table).bottom() - table.format().bottomMargin();
  bottoms_.push_back(std::max(rows.back().bottom + padding, frame));  // rows may be higher than their text
  const bool figures = is_figures(table);
  const int heads = std::min(table.format().headerRowCount(), table.rows() - 1);
  if (heads > 0) {
    const auto first = static_cast<std::size_t>(heads);
    const double edge = (rows[first - 1].bottom + rows[first].top) / 2;
    heads_.push_back({{rows.front().top - padding, edge + 1}, {edge + 2, rows.back().bottom}});
  }
  hold_table(rows, heads, figures);
  if (asks_for_page(table.format())) {
    forced_.push_back(rows.front().top);
  }
  Item item;
  item.kind = Item::Kind::table;
  item.whole = {rows.front().top, rows.back().bottom};
  item.first_until = rows[std::min(rows.size() - 1, static_cast<std::size_t>(heads))].bottom;
  item.last_from = rows.back().top;
  return item;
}

void FlowReader::hold_table(const std::vector<Extent>& rows, int heads, bool figures) {
  for (const Extent& row : rows) {
    hold(row.top, row.bottom, row_cost);
  }
  const Extent whole{rows.front().top, rows.back().bottom};
  if (figures) {
    return;
  }
  if (whole.height() <= height_) {
    hold(whole.top, whole.bottom, table_cost);
    return;
  }
  const std::size_t first = std::min(rows.size() - 1, static_cast<std::size_t>(heads));
  hold(whole.top, rows[first].bottom, row_cost);
  hold(whole.top, rows[std::min(rows.size() - 1, first + 1)].bottom, orphan_cost);
  hold(rows[rows.size() >= 2 ? rows.size() - 2 : 0].top, whole.bottom, orphan_cost);
}

void FlowReader::hold_items(const std::vector<Item>& items) {
  for (std::size_t i = 0; i + 1 < items.size(); ++i) {
    const Item& item = items[i];
    const Item& next = items[i + 1];
    if (item.kind == Item::Kind::heading) {
      hold(item.whole.top, next.first_until, heading_cost);
      const bool introduces = next.kind != Item::Kind::table && next.is_short() && i + 2 < items.size();
      if (introduces) {
        hold(item.whole.top, items[i + 2].first_until, lead_cost);
      }
    } else if (item.kind != Item::Kind::table &&
               (next.kind == Item::Kind::table || (next.in_list && !item.in_list))) {
      hold(item.last_from, next.first_until, lead_cost);
    } else if (item.kind == Item::Kind::table && next.kind == Item::Kind::note) {
      hold(item.last_from, next.whole.bottom, lead_cost);
    }
  }
}

const Heads* FlowReader::heads_at(double place) const {
  constexpr double most = 0.2;  // of a page
  const auto next =
      std::ranges::upper_bound(heads_, place, {}, [](const Heads& heads) { return heads.rows.top; });
  if (next == heads_.begin()) {
    return nullptr;
  }
  const Heads& heads = *std::prev(next);
  return place < heads.rows.bottom && heads.heads.height() < most * height_ ? &heads : nullptr;
}

std::vector<PageGap> FlowReader::gaps() const {
  std::vector<Extent> lines = lines_;
  std::ranges::sort(lines, {}, &Extent::top);
  std::vector<PageGap> gaps;
  double above = lines.front().bottom;
  for (const Extent& line : lines) {
    if (line.top >= above - 1e-3) {
      gaps.push_back({above, line.top, 0, false, 0});
    }
    above = std::max(above, line.bottom);
  }
  return gaps;
}

/// Assigns ends of tables and rows, costs and heads to the gaps.
void FlowReader::weigh(std::vector<PageGap>& gaps) const {
  for (const Hold& hold : holds_) {
    auto gap = std::ranges::upper_bound(gaps, hold.extent.top + rounding, {}, &PageGap::above);
    for (; gap != gaps.end() && gap->below < hold.extent.bottom - rounding; ++gap) {
      gap->cost = std::max(gap->cost, hold.cost);
    }
  }
  for (const double top : forced_) {
    const auto gap = std::ranges::lower_bound(gaps, top - rounding, {}, &PageGap::below);
    if (gap != gaps.end() && gap->below < top + rounding) {
      gap->forced = true;
    }
  }
  const std::vector<PageGap> lines = gaps;
  const auto at = [&](double place, auto use) {
    const auto found = std::ranges::upper_bound(lines, place, {}, &PageGap::below);
    if (found != lines.end() && found->above < place) {
      use(gaps[static_cast<std::size_t>(found - lines.begin())], *found);
    }
  };
  for (const double place : bottoms_) {
    at(place, [&](PageGap& gap, const PageGap&) { gap.above = std::max(gap.above, place); });
  }
  for (const double place : edges_) {
    at(place, [&](PageGap& gap, const PageGap& between) {
      gap.above = std::max(gap.above, place);
      gap.below = std::min(between.below, place + 1);
    });
  }
  for (const double place : tops_) {
    at(place,
       [&](PageGap& gap, const PageGap&) { gap.below = std::max(gap.above, std::min(gap.below, place)); });
  }
  for (PageGap& gap : gaps) {
    const Heads* heads = heads_at(gap.below);
    gap.head = heads != nullptr ? heads->heads.height() : 0;
  }
}

std::vector<PagePart> FlowReader::parts() {
  if (lines_.empty()) {
    return {PagePart{}};
  }
  Extent whole;
  for (const Extent& line : lines_) {
    whole.add(line);
  }
  for (const double place : tops_) {
    whole.top = std::min(whole.top, place);
  }
  for (const double place : bottoms_) {
    whole.bottom = std::max(whole.bottom, place);
  }
  std::ranges::sort(heads_, {}, [](const Heads& heads) { return heads.rows.top; });
  std::vector<PageGap> places = gaps();
  weigh(places);
  std::vector<PagePart> parts{PagePart{.top = whole.top}};
  for (const std::size_t index : best_page_breaks(places, whole.top, whole.bottom, height_)) {
    const PageGap& gap = places[index];
    parts.back().bottom = gap.above;
    parts.back().clip_bottom = std::min(gap.below, gap.above + border);
    parts.push_back(PagePart{.top = gap.below});
    if (const Heads* heads = gap.head > 0 ? heads_at(gap.below) : nullptr) {
      parts.back().head_top = heads->heads.top;
      parts.back().head_bottom = heads->heads.bottom;
    }
  }
  parts.back().bottom = whole.bottom;
  parts.back().clip_bottom = whole.bottom + border;
  return parts;
}

}  // namespace

std::vector<PagePart> page_parts(const QTextDocument& document, double height) {
  return FlowReader(document, height).parts();
}

}  // namespace feedscope::ui
