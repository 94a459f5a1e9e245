#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/program/path/plane_distance.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Watches the offset path of a tool's centre for places where the tool cuts into later parts of the
/// contour: necks and slots narrower than the tool, walls that come back.
///
/// A control looks some blocks ahead for them. Here the last `reach` pieces of the tool's path are stored in
/// groups with their boxes, which bounds the cost of an element.
/// - Cuts into *earlier* parts of the contour are not checked: successive passes into the material make them
/// on
///   purpose, and a neck is seen from either side.
/// - Other levels are not checked: a contour that is cut at several depths may change on its way down.
/// - Where the contour meets itself, as at the end of a round, it begins again: the ways to a closed contour
/// and
///   away from it may cross, and an element that continues past the meeting belongs to the round only up to
///   there. The offset path of a full circle, which passes all of it, is not watched.
class ContourWatch {
 public:
  static constexpr std::size_t reach = 4096;

  /// A cut into the contour.
  struct Cut {
    DiagnosticLog::Place beside;  ///< block whose path cuts
    double depth = 0;             ///< [mm]
  };
  /// Extent across the plane [mm].
  struct Levels {
    double low = 0;
    double high = 0;
  };

  void clear();
  /// Adds a piece of the path of the tool's centre.
  void add_path(const PlaneElement& path, const Levels& levels, const DiagnosticLog::Place& place);
  /// Adds the next element of the contour. Returns the pieces of the path so far that come closer to it than
  /// the tool's `radius` by more than `allowed` [mm], unless reported before.
  std::vector<Cut> add_contour(const PlaneElement& contour, const Levels& levels, double radius,
                               double allowed);

 private:
  struct Piece {
    PlaneElement element;
    PlaneBox box;
    Levels levels;
    DiagnosticLog::Place place;
    bool named = false;
  };
  class Window {
   public:
    void clear() { groups_.clear(); }
    void add(const Piece& piece);
    /// Calls `look(piece)` for pieces whose boxes come within `distance` of `box`.
    template <typename Look>
    void look_near(const PlaneBox& box, double distance, const Look& look);

   private:
    static constexpr std::size_t group_size = 64;
    struct Group {
      std::vector<Piece> pieces;
      PlaneBox box;
    };
    std::deque<Group> groups_;
  };

  bool meets_itself(const Piece& next);
  /// The contour's next element up to where it first meets an earlier part of the contour on its level.
  PlaneElement up_to_meeting(const Piece& next);

  Window paths_;
  Window contours_;
  std::optional<Piece> last_;  ///< element of the contour that is not in `contours_` yet
  bool beside_full_circle_ = false;
};

}  // namespace feedscope
