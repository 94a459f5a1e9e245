#pragma once

#include <QFont>
#include <QPainter>
#include <QPalette>
#include <vector>

#include "core/base/diagnostic.h"
#include "ui/program_text/line_cells.h"
#include "ui/program_text/syntax.h"

namespace feedscope::ui {

/// Draws one line of a program in a grid of cells.
class LinePainter {
 public:
  LinePainter() = default;
  LinePainter(const QFont& font, const QPalette& palette);

  double cell_width() const { return cell_width_; }
  int line_height() const { return line_height_; }

  /// Draws the cells [first, last) of a line; `left`: of cell 0, `top`: upper edge.
  void draw_text(QPainter& painter, double left, int top, const LineCells& cells,
                 const std::vector<Token>& tokens, std::uint32_t first, std::uint32_t last) const;
  /// Background of the cells [from, to).
  void fill(QPainter& painter, double left, int top, std::uint32_t from, std::uint32_t to,
            const QColor& colour) const;
  /// A wavy line below the cells [from, to); thicker for an error.
  void underline(QPainter& painter, double left, int top, std::uint32_t from, std::uint32_t to,
                 Severity severity) const;

 private:
  void draw_run(QPainter& painter, double left, int top, const LineCells& cells, std::uint32_t from,
                std::uint32_t to, TokenKind kind) const;

  QFont font_;
  QFont bold_;
  QPalette palette_;
  double cell_width_ = 1;
  int line_height_ = 1;
  int ascent_ = 0;
};

QColor colour_of(Severity severity, const QPalette& palette);

}  // namespace feedscope::ui
