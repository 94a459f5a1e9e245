#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/trajectory/trajectory.h"

namespace feedscope {

/// A place of the executed path that is far from the programmed one.
struct ContourPlace {
  double error = 0;           ///< distance from the nearest programmed point [mm]
  double side = 0;            ///< part in XY across the programmed direction, signed as in ContourErrors [mm]
  double time = 0;            ///< [s]
  double path_length = 0;     ///< executed, from the start [mm]
  std::uint32_t line = 0;     ///< source line under way
  std::uint32_t segment = 0;  ///< index of the programmed segment of `programmed`
  Vec3 position = Vec3::Zero();    ///< executed [mm]
  Vec3 programmed = Vec3::Zero();  ///< nearest programmed point [mm]
};

/// Length of executed path by error: `length[i]` [mm] between edges[i] and edges[i + 1] [mm].
struct ContourHistogram {
  std::vector<double> edges;
  std::vector<double> length;
};

/// Fine histogram from which histograms with other edges can be summed.
struct ContourSpread {
  double step = 0;             ///< a power of ten, at most 1/400 of the largest error [mm]
  std::vector<double> right;   ///< length [mm] with a signed part in XY from -(i + 1) * step to -i * step
  std::vector<double> left;    ///< from i * step to (i + 1) * step; includes stretches exactly on the path
  std::vector<double> amount;  ///< length [mm] by distance, from i * step to (i + 1) * step
  /// Share of the deviation in XY across the programmed direction, 0 to 1, weighted by length.
  double in_plane = 0;
};

enum class ContourBins : std::uint8_t {
  none,
  sides,        ///< signed part in XY, in equal bins of 1, 2 or 5 times a power of ten around 0
  amounts,      ///< distance, in equal bins of such a width from 0
  logarithmic,  ///< distance, edges 1 2 5 10 20 ...; the first bin from 0
};

struct ContourRequest {
  std::size_t places = 10;  ///< number of worst places wanted, at least 1
  ContourBins bins = ContourBins::none;
  /// Range of elements of the executed path that count, clamped to its end.
  std::uint32_t first_element = 0;
  std::uint32_t last_element = UINT32_MAX;
  bool spread = false;        ///< fill ContourErrors::spread
  bool cutting_only = false;  ///< rapids and corners between them do not count, nor does their length
};

/// Contour error of a run: distance of the executed path from the programmed one.
///
/// The side is positive where the executed path is to the left of the programmed direction of travel, seen
/// against Z: a corner that turns left is cut on its left side. It is 0 where the program moves along Z only.
struct ContourErrors {
  double largest = 0;               ///< of all [mm]
  double uncertainty = 0;           ///< largest possible amount by which `largest` is too small [mm]
  std::vector<ContourPlace> worst;  ///< largest first; between two of them the error at least halves
  ContourHistogram histogram;       ///< if requested
  ContourSpread spread;             ///< if requested
};

/// Computes contour errors. The error of a place is its distance from the nearest point of the whole
/// programmed path (see PathDeviation for paths that come near themselves); `largest` is the largest of all
/// executed places, within 1e-6 mm. At corners that a model rounds between programmed lines it has a closed
/// form, epsilon cos(turn/2) in the middle of the blend (distance from both lines, where epsilon is that from
/// the corner), unless another pass is nearer. There, and on filtered, fitted and compacted paths, spans
/// whose bound exceeds the largest distance found are halved (see ContourSearch).
///
/// Cost of the order of the elements times the logarithm of the segments. Throws Cancelled.
ContourErrors contour_errors(const Trajectory& trajectory, const ContourRequest& request = {},
                             Progress* progress = nullptr);

/// Largest contour error of a run's feed motions in the elements of `request` [mm]. `errors`: of all its
/// motions; if their worst place is in a rapid, a new search is made. Throws Cancelled.
double cutting_contour_error(const Trajectory& trajectory, const ContourErrors& errors,
                             ContourRequest request = {}, Progress* progress = nullptr);

/// An error for export: it is known to 1e-6 mm, so digits below 1e-9 mm are rounded off.
double rounded_error(double error);

}  // namespace feedscope
