#include "ui/program_text/line_painter.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/theme/program_colours.h"
#include "ui/theme/theme.h"

namespace feedscope::ui {

namespace {

constexpr int space_between_lines = 2;

QColor colour_of_kind(TokenKind kind, const QPalette& palette) {
  const ProgramColours& colours = program_colours(palette);
  switch (kind) {
    case TokenKind::comment:
      return colours.comment;
    case TokenKind::label:
      return colours.label;
    case TokenKind::block_delete:
      return colours.block_delete;
    case TokenKind::g_code:
      return colours.g_code;
    case TokenKind::m_code:
      return colours.m_code;
    case TokenKind::axis_x:
      return colours.axis_x;
    case TokenKind::axis_y:
      return colours.axis_y;
    case TokenKind::axis_z:
      return colours.axis_z;
    case TokenKind::other_axis:
      return colours.other_axis;
    case TokenKind::argument:
      return colours.argument;
    case TokenKind::feed:
      return colours.feed;
    case TokenKind::tool:
      return colours.tool;
    case TokenKind::keyword:
      return colours.keyword;
    case TokenKind::variable:
      return colours.variable;
    case TokenKind::literal:
      return colours.literal;
    case TokenKind::text:
      break;
  }
  return palette.color(QPalette::Text);
}

bool is_bold(TokenKind kind) {
  return kind == TokenKind::g_code || kind == TokenKind::keyword || kind == TokenKind::block_delete;
}

}  // namespace

QColor colour_of(Severity severity, const QPalette& palette) {
  const ThemeColours& colours = theme_colours(palette);
  switch (severity) {
    case Severity::error:
      return colours.error;
    case Severity::warning:
      return colours.warning;
    case Severity::info:
      break;
  }
  return colours.info;
}

LinePainter::LinePainter(const QFont& font, const QPalette& palette)
    : font_(font), bold_(font), palette_(palette) {
  bold_.setBold(true);
  const QFontMetricsF metrics(font_);
  cell_width_ = metrics.horizontalAdvance(QStringLiteral("0123456789")) / 10;
  line_height_ = static_cast<int>(std::ceil(metrics.height())) + space_between_lines;
  ascent_ = static_cast<int>(std::ceil(metrics.ascent())) + space_between_lines / 2;
}

void LinePainter::draw_run(QPainter& painter, double left, int top, const LineCells& cells,
                           std::uint32_t from, std::uint32_t to, TokenKind kind) const {
  if (from >= to) {
    return;
  }
  painter.setFont(is_bold(kind) ? bold_ : font_);
  painter.setPen(colour_of_kind(kind, palette_));
  for (const LineCells::Run& run : cells.runs(from, to)) {
    painter.drawText(QPointF(left + run.cell * cell_width_, top + ascent_), run.text);
  }
}

void LinePainter::draw_text(QPainter& painter, double left, int top, const LineCells& cells,
                            const std::vector<Token>& tokens, std::uint32_t first, std::uint32_t last) const {
  std::uint32_t at = cells.byte_at(first);
  const std::uint32_t end = cells.byte_at(last);
  for (const Token& token : tokens) {
    const std::uint32_t from = std::clamp(token.from, at, end);
    const std::uint32_t to = std::clamp(token.from + token.length, at, end);
    draw_run(painter, left, top, cells, at, from, TokenKind::text);
    draw_run(painter, left, top, cells, from, to, token.kind);
    at = to;
  }
  draw_run(painter, left, top, cells, at, end, TokenKind::text);
}

void LinePainter::fill(QPainter& painter, double left, int top, std::uint32_t from, std::uint32_t to,
                       const QColor& colour) const {
  painter.fillRect(QRectF(left + from * cell_width_, top, (to - from) * cell_width_, line_height_), colour);
}

void LinePainter::underline(QPainter& painter, double left, int top, std::uint32_t from, std::uint32_t to,
                            Severity severity) const {
  constexpr double half_wave = 3;  // [pixels]
  constexpr double amplitude = 2;
  const double right = left + to * cell_width_;
  const double low = top + line_height_ - 1;
  QPainterPath wave;
  double x = left + from * cell_width_;
  wave.moveTo(x, low);
  for (bool up = true; x < right; up = !up) {
    x = std::min(x + half_wave, right);
    wave.lineTo(x, up ? low - amplitude : low);
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour_of(severity, palette_), severity == Severity::error ? 1.6 : 1.0));
  painter.drawPath(wave);
  painter.restore();
}

}  // namespace feedscope::ui
