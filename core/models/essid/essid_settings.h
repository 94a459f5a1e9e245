#pragma once

#include "core/blend/corner.h"
#include "core/machine/settings.h"

namespace feedscope {

enum class EssidReading { corrected, published, strict };

/// Settings of the model in internal units.
struct EssidSettings {
  CornerRule corner;
  EssidReading reading = EssidReading::corrected;
  double period = 0.001;        ///< t_s [s]
  std::uint32_t lookahead = 8;  ///< blocks
  double radial_acceleration_share = 0.2;
  double radial_jerk_share = 0.2;

  explicit EssidSettings(const Settings& settings);
};

}  // namespace feedscope
