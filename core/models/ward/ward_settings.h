#pragma once

#include "core/compressor/compressor.h"
#include "core/machine/settings.h"

namespace feedscope {

/// Settings of the model in internal units.
struct WardSettings {
  int filters = 3;      ///< n
  double jerk = 0;      ///< J, for T1 = sqrt(F/J); 0: the least of the axes [mm/s3]
  double time = 0;      ///< T1 if above 0 [s]
  bool enforce = true;  ///< lower corners until the true contour error is within the tolerance
  CompressorSettings compressor;

  explicit WardSettings(const Settings& settings);
};

}  // namespace feedscope
