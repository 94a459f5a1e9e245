#include "ui/paper/line_pieces.h"

#include <QPainter>
#include <QPen>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace feedscope::ui {

namespace {

constexpr int colour_step = 8;       // of 255: less is not seen
constexpr double seen_share = 0.25;  // of the width of a line: shorter steps of colour are not seen

int difference(QRgb one, QRgb other) {
  return std::max({std::abs(qRed(one) - qRed(other)), std::abs(qGreen(one) - qGreen(other)),
                   std::abs(qBlue(one) - qBlue(other)), std::abs(qAlpha(one) - qAlpha(other))});
}

QRgb mixed(QRgb one, QRgb other, double share) {
  const auto part = [share](int a, int b) { return static_cast<int>(std::lround(std::lerp(a, b, share))); };
  return qRgba(part(qRed(one), qRed(other)), part(qGreen(one), qGreen(other)), part(qBlue(one), qBlue(other)),
               part(qAlpha(one), qAlpha(other)));
}

/// The fractions of a line at which it enters and leaves a rectangle, by Liang and Barsky; none if it misses.
std::optional<std::array<double, 2>> inside(const QRectF& room, const QPointF& from, const QPointF& to) {
  std::array<double, 2> shares{0, 1};
  const QPointF along = to - from;
  const std::array<std::array<double, 2>, 4> sides{{{-along.x(), from.x() - room.left()},
                                                    {along.x(), room.right() - from.x()},
                                                    {-along.y(), from.y() - room.top()},
                                                    {along.y(), room.bottom() - from.y()}}};
  for (const auto& [towards, distance] : sides) {
    if (towards == 0 && distance < 0) {
      return std::nullopt;
    }
    if (towards < 0) {
      shares[0] = std::max(shares[0], distance / towards);
    } else if (towards > 0) {
      shares[1] = std::min(shares[1], distance / towards);
    }
  }
  return shares[0] <= shares[1] ? std::optional(shares) : std::nullopt;
}

}  // namespace

bool LinePieces::look_alike(QRgb one, QRgb other) {
  return difference(one, other) <= colour_step / 2;
}

bool LinePieces::add(const LineEnd& from, const LineEnd& to, double width, bool round) {
  const double half = width / 2 + 0.5;  // including antialiased edges
  const auto shares = inside(room_.adjusted(half, half, -half, -half), from.at, to.at);
  if (!shares) {
    return true;
  }
  const QRgb first = from.colour.rgba();
  const QRgb last = to.colour.rgba();
  if (from.at == to.at && first != last) {
    return true;  // the colour of a path jumps here; the lines before and after it end here
  }
  const auto [enters, leaves] = *shares;
  const double part = leaves - enters;
  const QPointF along = to.at - from.at;
  const double most_colours = std::ceil(part * std::hypot(along.x(), along.y()) / (seen_share * width));
  const double pieces =
      std::max({1.0, std::ceil(part * std::abs(to.depth - from.depth) / max_depth),
                std::min(std::ceil(part * difference(first, last) / colour_step), most_colours)});
  if (static_cast<double>(pieces_.size()) + pieces > static_cast<double>(max_pieces)) {
    return false;
  }
  const auto place = [&](double share) { return from.at + share * (to.at - from.at); };
  for (double i = 0; i < pieces; ++i) {
    const double begin = enters + part * i / pieces;
    const double end = i + 1 < pieces ? enters + part * (i + 1) / pieces : leaves;
    const double middle = (begin + end) / 2;
    pieces_.push_back({place(begin), place(end),
                       static_cast<std::int64_t>(std::floor(std::lerp(from.depth, to.depth, middle))),
                       mixed(first, last, middle), width, round});
  }
  return true;
}

std::vector<LinePieces::Polyline> LinePieces::sorted() const {
  std::vector<Piece> pieces = pieces_;
  std::ranges::stable_sort(pieces, {}, &Piece::depth);
  std::vector<Polyline> lines;
  for (const Piece& piece : pieces) {
    const bool runs_on = !lines.empty() && lines.back().points.back() == piece.from &&
                         lines.back().width == piece.width && lines.back().round == piece.round &&
                         look_alike(lines.back().colour.rgba(), piece.colour);
    if (runs_on) {
      lines.back().points.append(piece.to);
    } else {
      lines.push_back(
          {QPolygonF({piece.from, piece.to}), QColor::fromRgba(piece.colour), piece.width, piece.round});
    }
  }
  return lines;
}

void paint(QPainter& painter, const std::vector<LinePieces::Polyline>& lines) {
  for (const LinePieces::Polyline& line : lines) {
    painter.setPen(
        QPen(line.colour, line.width, Qt::SolidLine, line.round ? Qt::RoundCap : Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(line.points);
  }
}

}  // namespace feedscope::ui
