#include "ui/program_text/program_view.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/program_text/line_time_text.h"
#include "ui/program_text/overview_strip.h"
#include "ui/program_text/program_margin.h"
#include "ui/theme/program_colours.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr double left_margin = 4;  // [pixels]
constexpr std::uint32_t cells_beyond = 4;
constexpr std::uint32_t longest_mark = 1000;  // [cells]

constexpr int to_int(std::uint32_t line) {
  return static_cast<int>(std::min<std::uint32_t>(line, std::numeric_limits<int>::max()));
}

}  // namespace

ProgramView::ProgramView(QWidget* parent)
    : QAbstractScrollArea(parent), margin_(new ProgramMargin(this)), overview_(new OverviewStrip(this)) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Program text"));
  setAccessibleDescription(tr("Text of the NC program with the time of every line"));
  viewport()->setCursor(Qt::IBeamCursor);
  viewport()->setBackgroundRole(QPalette::Base);
  viewport()->setAutoFillBackground(true);
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setFamilies({QStringLiteral("DejaVu Sans Mono"), fixed.family()});  // the same in every picture
  fixed.setPixelSize(default_font_size);
  setFont(fixed);
  connect(overview_, &OverviewStrip::line_pressed, this, [this](std::uint32_t line) {
    bring_line_into_sight(line);
    go_to({line, 0});
  });
  restyle();
}

void ProgramView::set_program(std::shared_ptr<const Program> program) {
  text_ = ProgramText(std::move(program));
  marks_ = text_.program() == nullptr ? DiagnosticMarks() : DiagnosticMarks(*text_.program());
  syntax_ = Syntax(text_.program() == nullptr ? Dialect::iso : text_.program()->dialect);
  times_ = nullptr;
  current_ = 0;
  caret_ = {};
  cells_ = static_cast<std::uint32_t>(text_.longest_line());
  place_strips();
  set_ranges();
  verticalScrollBar()->setValue(0);
  horizontalScrollBar()->setValue(0);
  refresh();
  emit caret_moved();
}

void ProgramView::set_times(std::shared_ptr<const LineTimes> times) {
  times_ = std::move(times);
  refresh();
}

void ProgramView::show_line(std::uint32_t line) {
  if (line == current_) {
    return;
  }
  current_ = line;
  if (!choosing_ && line > 0) {
    if (selection().empty()) {
      caret_.put(text_, {line, 0}, false);
      emit caret_moved();
    }
    bring_line_into_sight(line);
  }
  refresh();
}

void ProgramView::go_to(TextPlace place) {
  move_caret(place, false);
  choose(caret().line);
}

void ProgramView::select(TextRange range) {
  reveal(range);
  choose(caret().line);
}

void ProgramView::reveal(TextRange range) {
  caret_.select(text_, range);
  show_caret();
  ensure_visible(text_.clamped(range.begin));
}

void ProgramView::set_search(const TextSearch* search) {
  search_ = search;
  if (search_ != nullptr) {
    connect(search_, &TextSearch::changed, this, &ProgramView::refresh);
  }
  refresh();
}

void ProgramView::choose(std::uint32_t line) {
  if (text_.line_count() > 0) {
    const QScopedValueRollback guard(choosing_, true);
    emit line_chosen(line);
  }
}

void ProgramView::move_caret(TextPlace place, bool keep_anchor) {
  caret_.put(text_, place, keep_anchor);
  show_caret();
}

void ProgramView::show_caret() {
  ensure_visible(caret());
  refresh();
  emit caret_moved();
}

int ProgramView::font_size() const {
  return font().pixelSize();
}

void ProgramView::set_font_size(int pixels) {
  QFont changed = font();
  changed.setPixelSize(std::clamp(pixels, min_font_size, largest_font_size));
  if (changed.pixelSize() != font_size()) {
    setFont(changed);
    emit font_size_changed(changed.pixelSize());
  }
}

void ProgramView::zoom(int steps) {
  set_font_size(font_size() + steps);
}

/// Updates everything that depends on font and palette.
void ProgramView::restyle() {
  painter_ = LinePainter(font(), palette());
  place_strips();
  set_ranges();
  refresh();
}

void ProgramView::refresh() {
  viewport()->update();
  margin_->update();
  overview_->update();
}

void ProgramView::place_strips() {
  const int left = margin_->sizeHint().width();
  const int right = overview_->sizeHint().width();
  // Only if they change: this lays out the scroll bars, which may resize the viewport and call this again.
  if (const QMargins margins(left, 0, right, 0); viewportMargins() != margins) {
    setViewportMargins(margins);
  }
  const QRect inside = viewport()->geometry();
  margin_->setGeometry(inside.left() - left, inside.top(), left, inside.height());
  overview_->setGeometry(inside.right() + 1, inside.top(), right, inside.height());
}

int ProgramView::lines_in_sight() const {
  return std::max(1, viewport()->height() / line_height());
}

void ProgramView::set_ranges() {
  verticalScrollBar()->setRange(0, std::max(0, to_int(text_.line_count()) - lines_in_sight()));
  verticalScrollBar()->setPageStep(lines_in_sight());
  const double width = (cells_ + cells_beyond) * painter_.cell_width() + left_margin;
  const double beyond = std::clamp(width - viewport()->width(), 0.0, 1e9);
  horizontalScrollBar()->setRange(0, cells_ == 0 ? 0 : static_cast<int>(std::ceil(beyond)));
  horizontalScrollBar()->setSingleStep(static_cast<int>(std::ceil(4 * painter_.cell_width())));
  horizontalScrollBar()->setPageStep(viewport()->width());
}

std::uint32_t ProgramView::first_visible_line() const {
  return text_.line_count() == 0 ? 0 : static_cast<std::uint32_t>(verticalScrollBar()->value()) + 1;
}

std::uint32_t ProgramView::last_visible_line() const {
  if (text_.line_count() == 0) {
    return 0;
  }
  const auto rows = static_cast<std::uint32_t>((viewport()->height() + line_height() - 1) / line_height());
  return std::min(text_.line_count(), first_visible_line() + std::max(rows, 1U) - 1);
}

int ProgramView::top_of(std::uint32_t line) const {
  const auto rows = static_cast<std::int64_t>(line) - 1 - verticalScrollBar()->value();
  constexpr std::int64_t far = 1 << 24;
  return static_cast<int>(std::clamp(rows * line_height(), -far, far));
}

std::uint32_t ProgramView::line_at(int y) const {
  const std::int64_t row = std::int64_t{verticalScrollBar()->value()} +
                           static_cast<std::int64_t>(std::floor(static_cast<double>(y) / line_height()));
  return text_.line_count() == 0
             ? 0
             : static_cast<std::uint32_t>(std::clamp<std::int64_t>(row + 1, 1, text_.line_count()));
}

double ProgramView::left_edge() const {
  return left_margin - horizontalScrollBar()->value();
}

QRect ProgramView::place_rect(TextPlace place) const {
  const std::uint32_t cell = text_.cells(place.line).cell_of(place.byte);
  const double x = left_edge() + cell * painter_.cell_width();
  return QRectF(x, top_of(place.line), painter_.cell_width(), line_height()).toAlignedRect();
}

TextPlace ProgramView::place_at(const QPoint& point) const {
  const std::uint32_t line = line_at(point.y());
  const double cell = std::max(0.0, (point.x() - left_edge()) / painter_.cell_width() + 0.5);
  return {line, text_.cells(line).byte_at(static_cast<std::uint32_t>(cell))};
}

void ProgramView::bring_line_into_sight(std::uint32_t line) {
  if (!isVisible()) {  // the height is still unknown; showEvent() follows
    return;
  }
  const int row = to_int(line) - 1;
  const int first = verticalScrollBar()->value();
  if (row < first || row >= first + lines_in_sight()) {
    verticalScrollBar()->setValue(row - lines_in_sight() / 2);
  }
}

void ProgramView::ensure_visible(TextPlace place) {
  const int row = to_int(place.line) - 1;
  const int first = verticalScrollBar()->value();
  const int near = lines_in_sight();
  if (row < first - near || row >= first + 2 * near) {
    bring_line_into_sight(place.line);
  } else {
    verticalScrollBar()->setValue(std::clamp(first, row - lines_in_sight() + 1, row));
  }
  const QRect there = place_rect(place);
  const int x = horizontalScrollBar()->value();
  if (there.left() < 0) {
    horizontalScrollBar()->setValue(x + there.left() - static_cast<int>(4 * painter_.cell_width()));
  } else if (there.right() > viewport()->width()) {
    horizontalScrollBar()->setValue(x + there.right() - viewport()->width());
  }
}

void ProgramView::scrollContentsBy(int, int) {
  refresh();
}

void ProgramView::resizeEvent(QResizeEvent*) {
  place_strips();
  set_ranges();
}

void ProgramView::showEvent(QShowEvent* event) {
  QAbstractScrollArea::showEvent(event);
  if (current_ > 0) {
    bring_line_into_sight(current_);
  }
}

void ProgramView::set_reading(bool reading) {
  reading_ = reading;
  viewport()->update();
}

void ProgramView::say_without_program(const QString& text) {
  without_program_ = text;
  viewport()->update();
}

QString ProgramView::text_without_program() const {
  return without_program_.isEmpty() ? tr("Open an NC program (Ctrl+O), or drop one here.") : without_program_;
}

void ProgramView::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) {
    restyle();
  }
}

void ProgramView::paintEvent(QPaintEvent* event) {
  QPainter painter(viewport());
  if (text_.line_count() == 0) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(8, 6, -8, -6), Qt::TextWordWrap,
                     text_.program() != nullptr ? tr("The program is empty.")
                     : reading_                 ? tr("Reading the program …")
                                                : text_without_program());
    return;
  }
  const std::uint32_t last = std::min(last_visible_line(), line_at(event->rect().bottom()));
  for (std::uint32_t line = line_at(event->rect().top()); line <= last; ++line) {
    paint_line(painter, line);
  }
  paint_caret(painter);
}

void ProgramView::paint_line(QPainter& painter, std::uint32_t line) {
  static const std::vector<Token> none;
  const std::string_view bytes = text_.line(line);
  const LineCells cells = text_.cells(line);
  const auto& tokens = bytes.size() > LineCells::longest_decoded ? none : syntax_.tokens_of(bytes);
  paint_ground(painter, line, cells);
  const double first = std::max(0.0, -left_edge() / painter_.cell_width());
  const double seen = viewport()->width() / painter_.cell_width() + 2;
  painter_.draw_text(painter, left_edge(), top_of(line), cells, tokens, static_cast<std::uint32_t>(first),
                     static_cast<std::uint32_t>(first + seen));
  paint_marks(painter, line, cells, tokens);
  if (cells.count() > cells_) {  // contains tabs
    cells_ = cells.count();
    set_ranges();
  }
}

void ProgramView::paint_ground(QPainter& painter, std::uint32_t line, const LineCells& cells) const {
  const QRect row(0, top_of(line), viewport()->width(), line_height());
  if (line == current_) {
    painter.fillRect(row, theme_colours(palette()).current_line);
  } else if (line == caret().line && current_ > 0) {
    painter.setPen(program_colours(palette()).caret_line);
    painter.drawRect(row.adjusted(0, 0, -1, -1));
  }
  if (search_ != nullptr && search_->found() != nullptr && search_->found()->any(line, line)) {
    for (const TextRange& hit : search_->hits_in(line)) {
      painter_.fill(painter, left_edge(), row.top(), cells.cell_of(hit.begin.byte),
                    cells.cell_of(hit.end.byte), program_colours(palette()).found);
    }
  }
  const TextRange selected = selection();
  if (!selected.empty() && line >= selected.begin.line && line <= selected.end.line) {
    const std::uint32_t from = line == selected.begin.line ? cells.cell_of(selected.begin.byte) : 0;
    const std::uint32_t to =
        line == selected.end.line ? cells.cell_of(selected.end.byte) : cells.count() + 1;  // end of the line
    QColor ground = palette().color(QPalette::Highlight);
    ground.setAlphaF(hasFocus() ? 0.4F : 0.25F);
    painter_.fill(painter, left_edge(), row.top(), from, to, ground);
  }
}

void ProgramView::paint_marks(QPainter& painter, std::uint32_t line, const LineCells& cells,
                              const std::vector<Token>& tokens) const {
  const std::string_view bytes = text_.line(line);
  for (const Diagnostic* diagnostic : marks_.of(line)) {
    const ByteRange range = marked_bytes(bytes, diagnostic->column, tokens);
    const std::uint32_t from = cells.cell_of(range.from);
    const std::uint32_t to = std::clamp(cells.cell_of(range.to), from + 1, from + longest_mark);
    painter_.underline(painter, left_edge(), top_of(line), from, to, diagnostic->severity);
  }
}

void ProgramView::paint_caret(QPainter& painter) const {
  if (hasFocus()) {
    const QRect place = place_rect(caret());
    painter.fillRect(QRect(place.left(), place.top(), 2, place.height()), palette().color(QPalette::Text));
  }
}

QString ProgramView::tip_at(const QPoint& point) const {
  const std::uint32_t line = line_at(point.y());
  if (line == 0 || point.y() >= top_of(line) + line_height()) {
    return {};
  }
  return marks_.tip(line);
}

bool ProgramView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tip_at(help->pos()), viewport());
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

bool ProgramView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {  // Ctrl+Home belongs to the text here, not to the window
    auto* key = static_cast<QKeyEvent*>(event);
    if (caret_movement_of(*key) || key->matches(QKeySequence::Copy) ||
        key->matches(QKeySequence::SelectAll)) {
      event->accept();
      return true;
    }
  }
  return QAbstractScrollArea::event(event);
}

void ProgramView::keyPressEvent(QKeyEvent* event) {
  if (text_.line_count() == 0) {
    QAbstractScrollArea::keyPressEvent(event);
  } else if (const auto movement = caret_movement_of(*event)) {
    if (!movement->selects && !selection().empty() && current_ > 0 && caret().line != current_) {
      caret_.put(text_, {current_, 0}, false);  // playback continued while a selection was kept
    }
    const std::uint32_t line = caret().line;
    caret_.move(text_, *movement, static_cast<std::uint32_t>(lines_in_sight()));
    show_caret();
    if (!movement->selects && caret().line != line) {
      choose(caret().line);
    }
  } else if (event->matches(QKeySequence::Copy)) {
    copy();
  } else if (event->matches(QKeySequence::SelectAll)) {
    select_all();
  } else {
    QAbstractScrollArea::keyPressEvent(event);
  }
}

void ProgramView::copy() const {
  if (!selection().empty()) {
    QApplication::clipboard()->setText(selected_text());
  }
}

void ProgramView::select_all() {
  caret_.select(text_, {{}, text_.end()});
  refresh();
  emit caret_moved();
}

void ProgramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || text_.line_count() == 0) {
    return;
  }
  const bool extends = (event->modifiers() & Qt::ShiftModifier) != 0;
  move_caret(place_at(event->position().toPoint()), extends);
  if (!extends) {
    choose(caret().line);
  }
}

void ProgramView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && text_.line_count() > 0) {
    const TextRange word = text_.word_at(place_at(event->position().toPoint()));
    caret_.select(text_, word);
    show_caret();
  }
}

void ProgramView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0 || text_.line_count() == 0) {
    return;
  }
  drag_point_ = event->position().toPoint();
  drag_to(drag_point_);
  constexpr int scroll_interval = 50;  // [ms]
  if (viewport()->rect().contains(drag_point_)) {
    drag_timer_.stop();
  } else if (!drag_timer_.isActive()) {
    drag_timer_.start(scroll_interval, this);
  }
}

void ProgramView::drag_to(const QPoint& point) {
  move_caret(place_at(point), true);
}

void ProgramView::timerEvent(QTimerEvent* event) {
  if (event->timerId() == drag_timer_.timerId()) {
    drag_to(drag_point_);
  }
}

void ProgramView::mouseReleaseEvent(QMouseEvent* event) {
  drag_timer_.stop();
  QClipboard* clipboard = QApplication::clipboard();
  if (event->button() == Qt::LeftButton && clipboard->supportsSelection() && !selection().empty()) {
    clipboard->setText(selected_text(), QClipboard::Selection);
  }
}

void ProgramView::wheelEvent(QWheelEvent* event) {
  if ((event->modifiers() & Qt::ControlModifier) == 0) {
    QAbstractScrollArea::wheelEvent(event);
    return;
  }
  wheel_rest_ += event->angleDelta().y();
  const int steps = wheel_rest_ / QWheelEvent::DefaultDeltasPerStep;
  wheel_rest_ -= steps * QWheelEvent::DefaultDeltasPerStep;
  zoom(steps);
  event->accept();
}

void ProgramView::focusInEvent(QFocusEvent*) {
  viewport()->update();
}

void ProgramView::focusOutEvent(QFocusEvent*) {
  viewport()->update();
}

}  // namespace feedscope::ui
