#include "ui/views/program_view.h"

#include <QFontDatabase>
#include <QPainter>
#include <QScopedValueRollback>
#include <QTextBlock>
#include <algorithm>

#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr int number_margin = 6;

class NumberArea : public QWidget {
 public:
  explicit NumberArea(ProgramView* view) : QWidget(view), view_(view) {}
  QSize sizeHint() const override { return {view_->number_area_width(), 0}; }

 protected:
  void paintEvent(QPaintEvent* event) override { view_->paint_number_area(event); }

 private:
  ProgramView* view_;
};

}  // namespace

ProgramView::ProgramView(QWidget* parent) : QPlainTextEdit(parent), number_area_(new NumberArea(this)) {
  setReadOnly(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setUndoRedoEnabled(false);
  setFrameShape(QFrame::NoFrame);
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setFamilies({QStringLiteral("DejaVu Sans Mono"), fixed.family()});  // the same in every picture
  fixed.setPixelSize(12);
  setFont(fixed);
  setPlaceholderText(tr("Open an NC program (Ctrl+O), or drop one here."));
  setAccessibleName(tr("Program text"));
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ProgramView::place_number_area);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &ProgramView::follow_text_cursor);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
    if (dy != 0) {
      number_area_->scroll(0, dy);
    } else {
      number_area_->update(0, rect.y(), number_area_->width(), rect.height());
    }
  });
  place_number_area();
}

void ProgramView::set_text(const QString& text) {
  const QScopedValueRollback guard(showing_, true);
  current_ = 0;
  setPlainText(text);
  mark_current();
}

void ProgramView::show_line(std::uint32_t line) {
  if (line == current_) {
    return;
  }
  const QScopedValueRollback guard(showing_, true);
  current_ = line;
  const QTextBlock block = document()->findBlockByNumber(static_cast<int>(line) - 1);
  if (block.isValid()) {
    setTextCursor(QTextCursor(block));
    if (!viewport()->rect().contains(cursorRect().center())) {
      centerCursor();
    }
  }
  mark_current();
}

void ProgramView::follow_text_cursor() {
  if (showing_ || document()->isEmpty()) {
    return;
  }
  emit line_chosen(static_cast<std::uint32_t>(textCursor().blockNumber()) + 1);
}

void ProgramView::mark_current() {
  QList<QTextEdit::ExtraSelection> marks;
  const QTextBlock block = document()->findBlockByNumber(static_cast<int>(current_) - 1);
  if (block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.format.setBackground(theme_colours(palette()).current_line);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = QTextCursor(block);
    marks.append(mark);
  }
  setExtraSelections(marks);
  number_area_->update();
}

int ProgramView::number_area_width() const {
  const auto digits = QString::number(std::max(100, blockCount())).size();
  return 2 * number_margin + static_cast<int>(digits) * fontMetrics().horizontalAdvance('9');
}

void ProgramView::paint_number_area(QPaintEvent* event) {
  QPainter painter(number_area_);
  const ThemeColours& colours = theme_colours(palette());
  painter.fillRect(event->rect(), colours.gutter);
  painter.setFont(font());
  QTextBlock block = firstVisibleBlock();
  double top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= event->rect().bottom()) {
    const double height = blockBoundingRect(block).height();
    const bool current = block.blockNumber() + 1 == static_cast<int>(current_);
    const QRectF row(0, top, number_area_->width(), height);
    if (current) {
      painter.fillRect(row, colours.current_line);
    }
    painter.setPen(current ? palette().color(QPalette::Text) : colours.muted);
    painter.drawText(row.adjusted(0, 0, -number_margin, 0), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(block.blockNumber() + 1));
    top += height;
    block = block.next();
  }
}

void ProgramView::place_number_area() {
  setViewportMargins(number_area_width(), 0, 0, 0);
  const QRect inside = contentsRect();
  number_area_->setGeometry(inside.left(), inside.top(), number_area_width(), inside.height());
}

void ProgramView::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  place_number_area();
}

void ProgramView::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange) {
    place_number_area();
  }
}

}  // namespace feedscope::ui
