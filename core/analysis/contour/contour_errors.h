#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A place of the executed path that is far from the programmed one.
struct ContourPlace {
  double error = 0;                ///< distance from the nearest programmed point [mm]
  double side = 0;                 ///< its part in XY across the programmed direction, as ContourErrors [mm]
  double time = 0;                 ///< [s]
  double path_length = 0;          ///< executed, from the start [mm]
  std::uint32_t line = 0;          ///< source line that is executed
  std::uint32_t segment = 0;       ///< of the programmed path, that `programmed` lies on
  Vec3 position = Vec3::Zero();    ///< executed [mm]
  Vec3 programmed = Vec3::Zero();  ///< the nearest programmed point [mm]
};

/// How much of the executed path has which error: `length[i]` [mm] between edges[i] and edges[i + 1] [mm].
struct ContourHistogram {
  std::vector<double> edges;
  std::vector<double> length;
};

/// The same in steps so fine that histograms with other edges can be summed up from them.
struct ContourSpread {
  double step = 0;             ///< a power of ten, at most 1/400 of the largest error [mm]
  std::vector<double> right;   ///< length [mm] with a signed part in XY from -(i + 1) * step to -i * step
  std::vector<double> left;    ///< from i * step to (i + 1) * step; also what follows the path exactly
  std::vector<double> amount;  ///< length [mm] by distance, from i * step to (i + 1) * step
  /// Share of the deviation that lies in XY across the programmed direction, 0 to 1, weighed by length.
  double in_plane = 0;
};

enum class ContourBins : std::uint8_t {
  none,
  sides,        ///< signed part in XY, in equal bins of 1, 2 or 5 times a power of ten around 0
  amounts,      ///< distance, in equal bins of such a width from 0
  logarithmic,  ///< distance, edges 1 2 5 10 20 ...; the first bin from 0
};

struct ContourRequest {
  std::size_t places = 10;  ///< how many of the worst are wanted, at least 1
  ContourBins bins = ContourBins::none;
  /// Elements of the executed path that count; the end is cut to the path's.
  std::uint32_t first_element = 0;
  std::uint32_t last_element = UINT32_MAX;
  bool spread = false;        ///< whether ContourErrors::spread is wanted
  bool cutting_only = false;  ///< rapids, and corners between them, do not count; nor does their length
};

/// Contour error of a run: how far the executed path is from the programmed one.
///
/// The side is positive where the executed path lies left of the programmed direction of travel, seen against
/// Z: a corner that turns left is cut on its left side. It is 0 where the program moves along Z alone.
struct ContourErrors {
  double largest = 0;               ///< of all [mm]
  double uncertainty = 0;           ///< by how much `largest` may be too small at most [mm]
  std::vector<ContourPlace> worst;  ///< the largest first; between two of them the error halves at least
  ContourHistogram histogram;       ///< if asked for
  ContourSpread spread;             ///< if asked for
};

/// The error of a place is its distance from the nearest point of the whole programmed path (PathDeviation
/// says what that means where a path comes near itself); `largest` is the largest of all executed places, but
/// for 1e-6 mm. On corners that a model rounds between programmed lines it is known in closed form, epsilon
/// cos(turn/2) in the middle of the blend (its distance from both lines, epsilon being that from the corner),
/// unless another pass is nearer; there, and on filtered, fitted and compacted paths, spans whose bound is
/// above the largest distance found are halved (see ContourSearch).
///
/// Cost in the order of the elements times the logarithm of the segments. Throws Cancelled.
ContourErrors contour_errors(const Trajectory& trajectory, const ContourRequest& request = {},
                             Progress* progress = nullptr);

/// The largest of the feed motions of a run, of those elements that `request` names, whose worst place of all
/// `errors` know [mm]: a search of its own where that is in a rapid. Throws Cancelled.
double cutting_contour_error(const Trajectory& trajectory, const ContourErrors& errors,
                             ContourRequest request = {}, Progress* progress = nullptr);

/// An error as it is exported: known to 1e-6 mm, so that what is below 1e-9 mm says nothing.
double rounded_error(double error);

}  // namespace feedscope
