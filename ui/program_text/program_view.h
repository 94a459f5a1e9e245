#pragma once

#include <QAbstractScrollArea>
#include <QBasicTimer>
#include <cstdint>
#include <memory>

#include "core/analysis/time/line_times.h"
#include "ui/program_text/caret.h"
#include "ui/program_text/diagnostic_marks.h"
#include "ui/program_text/line_painter.h"
#include "ui/program_text/program_text.h"
#include "ui/program_text/syntax.h"
#include "ui/program_text/text_search.h"

namespace feedscope::ui {

class OverviewStrip;
class ProgramMargin;

/// A program's text, read only, with line numbers, a heat strip with the time of each line, syntax colours by
/// dialect and underlined diagnostics. Draws the visible lines directly from the program, so that its length
/// does not matter.
///
/// The *current* line is that of the run's cursor; the *caret* is the position of the keyboard.
class ProgramView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  static constexpr int min_font_size = 6;  ///< [pixels]
  static constexpr int default_font_size = 12;
  static constexpr int largest_font_size = 48;

  explicit ProgramView(QWidget* parent = nullptr);

  /// Null: no program. Goes to its start.
  void set_program(std::shared_ptr<const Program> program);
  /// Times of a run of the program; null: none.
  void set_times(std::shared_ptr<const LineTimes> times);
  /// Makes a 1-based line the current one and scrolls to it; 0: none. Does not emit line_chosen().
  void show_line(std::uint32_t line);
  std::uint32_t current_line() const { return current_; }

  /// Moves the caret like the user: scrolls to it and emits line_chosen().
  void go_to(TextPlace place);
  /// As go_to(), with the caret at the end of a selection.
  void select(TextRange range);
  /// As select(), without line_chosen().
  void reveal(TextRange range);
  /// Search whose hits are marked; null: none. Outlives this.
  void set_search(const TextSearch* search);
  /// Whether a program is being read, which is shown while there is no text.
  void set_reading(bool reading);
  /// Text shown without a program instead of how to open one; empty: none.
  void say_without_program(const QString& text);
  QString text_without_program() const;
  const TextSearch* search() const { return search_; }

  const ProgramText& text() const { return text_; }
  const std::shared_ptr<const LineTimes>& times() const { return times_; }
  const DiagnosticMarks& marks() const { return marks_; }
  TextPlace caret() const { return caret_.place(); }
  TextRange selection() const { return caret_.selection(); }
  QString selected_text() const { return text_.text(selection()); }

  int font_size() const;  ///< [pixels]
  void set_font_size(int pixels);

  std::uint32_t first_visible_line() const;
  std::uint32_t last_visible_line() const;  ///< even if only partly visible; 0: no program
  int line_height() const { return painter_.line_height(); }
  /// Upper edge of a line in the viewport.
  int top_of(std::uint32_t line) const;
  /// The line at a height of the viewport, at most the last one; 0: no program.
  std::uint32_t line_at(int y) const;
  /// Place of a character in the viewport.
  QRect place_rect(TextPlace place) const;

 public slots:
  void copy() const;
  void select_all();
  void zoom(int steps);

 signals:
  /// The user went to a line, by mouse or keyboard.
  void line_chosen(std::uint32_t line);
  void caret_moved();
  void font_size_changed(int pixels);

 protected:
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void timerEvent(QTimerEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  void restyle();
  void place_strips();
  void set_ranges();
  int lines_in_sight() const;
  void refresh();
  void ensure_visible(TextPlace place);
  void bring_line_into_sight(std::uint32_t line);
  void move_caret(TextPlace place, bool keep_anchor);
  void show_caret();
  void choose(std::uint32_t line);
  TextPlace place_at(const QPoint& point) const;
  double left_edge() const;
  void drag_to(const QPoint& point);

  void paint_line(QPainter& painter, std::uint32_t line);
  void paint_ground(QPainter& painter, std::uint32_t line, const LineCells& cells) const;
  void paint_marks(QPainter& painter, std::uint32_t line, const LineCells& cells,
                   const std::vector<Token>& tokens) const;
  void paint_caret(QPainter& painter) const;
  QString tip_at(const QPoint& point) const;

  ProgramText text_;
  DiagnosticMarks marks_;
  std::shared_ptr<const LineTimes> times_;
  const TextSearch* search_ = nullptr;
  Syntax syntax_;
  LinePainter painter_;
  ProgramMargin* margin_;
  OverviewStrip* overview_;
  bool reading_ = false;
  QString without_program_;
  std::uint32_t current_ = 0;
  Caret caret_;
  std::uint32_t cells_ = 0;  ///< of the longest known line
  bool choosing_ = false;    ///< line_chosen() is being emitted: show_line() replies to it
  QBasicTimer drag_timer_;
  QPoint drag_point_;
  int wheel_rest_ = 0;
};

}  // namespace feedscope::ui
