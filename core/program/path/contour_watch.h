#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "core/program/path/plane_distance.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Watches the path of a tool's centre beside a contour for places where the tool cuts into what of the
/// contour comes later: necks and slots narrower than the tool, walls that come back.
///
/// A control looks some blocks ahead for that; here the last `reach` pieces of the tool's path are kept, in
/// groups with their boxes, which bounds the cost of an element.
/// - What the tool cuts of the contour *behind* it is not looked at: passes that go one after the other into
///   the material do that on purpose, and a neck is seen from either side.
/// - Nor what lies on other levels: a contour that is cut at several depths may change on its way down.
/// - Where the contour meets itself, as at the end of a round, it begins again: what leads to a closed
/// contour
///   and away from it may cross, and an element that runs on past the meeting belongs to the round up to
///   there only. The path beside a full circle, which leads past all of it, is not watched.
class ContourWatch {
 public:
  static constexpr std::size_t reach = 4096;

  /// A cut into the contour.
  struct Cut {
    DiagnosticLog::Place beside;  ///< of the block whose path cuts
    double depth = 0;             ///< [mm]
  };
  /// Extent across the plane [mm].
  struct Levels {
    double low = 0;
    double high = 0;
  };

  void clear();
  /// Where the tool's centre runs.
  void add_path(const PlaneElement& path, const Levels& levels, const DiagnosticLog::Place& place);
  /// The next element of the contour: what of the path so far comes closer to it than the tool's `radius` by
  /// more than `allowed` [mm], unless it was named before.
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
    /// Calls `look(piece)` for those whose boxes come within `distance` of `box`.
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
  /// The contour's next element up to where it first meets what of the contour came before on its level.
  PlaneElement up_to_meeting(const Piece& next);

  Window paths_;
  Window contours_;
  std::optional<Piece> last_;  ///< element of the contour, not among `contours_` yet
  bool beside_full_circle_ = false;
};

}  // namespace feedscope
