#pragma once

#include <QColor>
#include <QPolygonF>
#include <QRectF>
#include <cstdint>
#include <vector>

class QPainter;

namespace feedscope::ui {

/// One end of a line of the 3D view, as it is seen.
struct LineEnd {
  QPointF at;        ///< [pixels]
  double depth = 0;  ///< towards the eye [pixels at scale 1]
  QColor colour;
};

/// Lines of a 3D view as flat polylines that can be painted one over the other: the painter's algorithm.
///
/// Long lines are cut where their depth or colour changes much, everything is sorted by depth in steps of a
/// pixel, and neighbours in one line that come out one after the other are joined again. So what is nearer
/// lies above what is farther, to within half of max_depth.
class LinePieces {
 public:
  /// A piece changes its depth by no more than this many pixels.
  static constexpr double max_depth = 8;
  /// More pieces than this are refused: files grow by some 40 bytes a piece.
  static constexpr std::size_t max_pieces = 250'000;

  /// Lines outside of `room` [pixels] are omitted, and those that reach out of it cut, ends and all.
  explicit LinePieces(const QRectF& room) : room_(room) {}

  /// `round`: its ends, and where it is joined to others. Lines in one place: those added later are above.
  /// False: there are too many pieces, and nothing more is added.
  bool add(const LineEnd& from, const LineEnd& to, double width, bool round);
  std::size_t count() const { return pieces_.size(); }

  /// A line that runs on in one look.
  struct Polyline {
    QPolygonF points;
    QColor colour;
    double width = 1;  ///< [pixels]
    bool round = false;
  };
  /// The farthest first.
  std::vector<Polyline> sorted() const;

 private:
  struct Piece {
    QPointF from;
    QPointF to;
    std::int64_t depth = 0;
    QRgb colour = 0;
    double width = 1;
    bool round = false;
  };
  static bool look_alike(QRgb one, QRgb other);

  QRectF room_;
  std::vector<Piece> pieces_;
};

void paint(QPainter& painter, const std::vector<LinePieces::Polyline>& lines);

}  // namespace feedscope::ui
