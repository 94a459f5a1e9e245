#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/scene/sampled_path.h"
#include "ui/scene/scene_style.h"

namespace feedscope::ui {

std::string colouring_title(Colouring colouring, const SceneTexts& texts);

/// Scale of a quantity, in display units.
struct ColourScale {
  std::string unit;  ///< "mm/min"
  double low = 0;
  double high = 0;         ///< 0 if there is nothing to colour
  double factor = 1;       ///< display units per unit of the samples
  bool beyond = false;     ///< rare values are beyond the ends and have their colour
  bool diverging = false;  ///< low = -high
  bool from_pale = false;  ///< pale at low, where nothing differs
  /// Position of a value of the samples, 0 at low and 1 at high.
  double position(double value) const { return (value * factor - low) / (high - low); }
};

/// Share of a cause in the run's time.
struct CauseShare {
  CauseKind kind = CauseKind::programmed_feed;
  double share = 0;  ///< of the cycle time, as in tables and charts [0, 1]
};

/// Additional time of a cause compared with the other run.
struct CauseChange {
  CauseKind kind = CauseKind::programmed_feed;
  double time = 0;  ///< [s]
};

/// Meaning of a path's colours: nothing, a scale, or causes.
struct ColourKey {
  Colouring colouring = Colouring::feed;
  ColourScale scale;
  std::vector<CauseShare> causes;      ///< the longest first
  std::string reference;               ///< the run compared with, if any; may be empty
  double lost = 0;                     ///< in total against that run, for Colouring::time_lost [s]
  std::vector<CauseChange> changes{};  ///< the largest contributions to `lost`, the largest first

  bool has_scale() const { return scale.high > scale.low; }
};

/// Ends at round values. The few thousandths of points with the largest accelerations, jerks and errors do
/// not extend the scale if they are far above the others. Linear in the points.
ColourKey colour_key(const SampledPath& path, Colouring colouring);
/// A common key for two paths: the scale covers both.
ColourKey colour_key(const SampledPath& path, const SampledPath& other, Colouring colouring);

using Rgba = std::array<unsigned char, 4>;
static_assert(sizeof(Rgba) == 4);

/// Colour at every point. `run`: for Colouring::run.
std::vector<Rgba> point_colours(const SampledPath& path, const ColourKey& key, Background background,
                                const Rgb& run);
Rgb scale_colour(const ColourScale& scale, double position, Background background);

}  // namespace feedscope::ui
