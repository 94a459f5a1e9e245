#pragma once

#include <QColor>
#include <QPolygonF>
#include <QRectF>
#include <cstdint>
#include <vector>

class QPainter;

namespace feedscope::ui {

/// One end of a line in the 3D view, projected.
struct LineEnd {
  QPointF at;        ///< [pixels]
  double depth = 0;  ///< towards the eye [pixels at scale 1]
  QColor colour;
};

/// Lines of a 3D view as flat polylines, painted one over the other: the painter's algorithm.
///
/// Long lines are cut where their depth or colour changes much. All pieces are sorted by depth in steps of a
/// pixel, and adjacent pieces of a line that are neighbours in this order are joined again. So nearer lines
/// cover farther ones, to within half of max_depth.
class LinePieces {
 public:
  /// Largest change of depth in a piece [pixels at scale 1].
  static constexpr double max_depth = 8;
  /// Largest number of pieces: files grow by some 40 bytes per piece.
  static constexpr std::size_t max_pieces = 250'000;

  /// Lines outside of `room` [pixels] are omitted; lines that cross its border are cut, including round ends.
  explicit LinePieces(const QRectF& room) : room_(room) {}

  /// `round`: its ends and joints. Of lines in one place, those added later are above. False if there are too
  /// many pieces; then nothing more is added.
  bool add(const LineEnd& from, const LineEnd& to, double width, bool round);
  std::size_t count() const { return pieces_.size(); }

  /// A continuous line of one appearance.
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
