#pragma once

#include <array>

#include "core/program/iso/context.h"

namespace feedscope::iso {

/// Reports words of a block that are not simulated: axes other than X, Y and Z, words without meaning.
class WordChecks : private Part {
 public:
  explicit WordChecks(Context& context) : Part(context) {}

  void run();

 private:
  void check_other_axes();
  /// I, J and K of a line under G43.5.
  void orient_tool();
  AxisBlock beside_motion(bool alone, bool rapid) const;
  void check_unused() const;

  std::array<double, 6> other_axes_{};  ///< A B C U V W as written
};

}  // namespace feedscope::iso
