#include "ui/runs/cause_bar.h"

#include <QCoreApplication>
#include <QPainter>

#include "ui/language/core_texts.h"
#include "ui/shared/plot_text.h"
#include "ui/theme/cause_colours.h"

namespace feedscope::ui {

namespace {

struct BarTexts {
  Q_DECLARE_TR_FUNCTIONS(feedscope::ui::ComparisonChart)
};

constexpr double seen = 0.4;     // [px]
constexpr double separated = 3;  // wider parts are separated from the previous one by a white line
const QColor rest_color(0xb4, 0xba, 0xc2);
const QColor refused_color(0xff, 0xff, 0xff, 0xa0);

/// The part of a piece for a text that does not cross the line at `x`: the wider side.
QRectF clear_side(const QRectF& piece, double x) {
  if (x <= piece.left() || x >= piece.right()) {
    return piece;
  }
  QRectF side = piece;
  if (x - piece.left() > piece.right() - x) {
    side.setRight(x);
  } else {
    side.setLeft(x);
  }
  return side;
}

}  // namespace

void fill_cause(QPainter& painter, const QRectF& area, const std::optional<CauseKind>& kind) {
  if (kind) {
    painter.fillRect(area, colour_of_cause(*kind));
  } else {
    painter.fillRect(area, Qt::white);
    painter.fillRect(area, QBrush(rest_color, Qt::BDiagPattern));
    painter.setPen(QPen(rest_color, 1));
    painter.drawRect(area.adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void hatch_refused(QPainter& painter, const QRectF& area) {
  painter.fillRect(area, QBrush(refused_color, Qt::FDiagPattern));
}

std::vector<QString> cause_legend(const ComparisonBars& bars) {
  std::vector<QString> texts;
  for (const CauseKind kind : bars.kinds) {
    texts.push_back(shown_cause({kind, -1}));
  }
  if (bars.rest) {
    texts.push_back(BarTexts::tr("other causes"));
  }
  return texts;
}

double paint_cause_bar(QPainter& painter, const ComparisonBar& bar, const CauseBar& how) {
  double left = how.place.left();
  for (const BarPart& part : bar.parts) {
    const QRectF piece(left, how.place.top(), part.time * how.pixels_per_second, how.place.height());
    const auto kind = part.cause ? std::optional(part.cause->kind) : std::nullopt;
    if (!kind && piece.width() < seen) {  // its outline would be wider
      left = piece.right();
      continue;
    }
    fill_cause(painter, piece, kind);
    if (bar.lines_not_run > 0) {
      hatch_refused(painter, piece);
    }
    if (left > how.place.left() && piece.width() > separated) {
      painter.setPen(QPen(Qt::white, 1));
      painter.drawLine(piece.topLeft(), piece.bottomLeft());
    }
    const QRectF room = how.line ? clear_side(piece, *how.line) : piece;
    painter.setPen(text_on(kind ? colour_of_cause(*kind) : QColor(Qt::white)));
    painter.drawText(room, Qt::AlignCenter, how.text(part, room.width()));
    left = piece.right();
  }
  return left;
}

}  // namespace feedscope::ui
