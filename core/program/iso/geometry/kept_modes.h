#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/coordinates.h"

namespace feedscope::iso {

/// M70 to M73 of LinuxCNC: stores the modal state of a call, and restores it.
class KeptModes : private Part {
 public:
  /// Both outlive it.
  KeptModes(Context& context, Coordinates& coordinates) : Part(context), coordinates_(coordinates) {}

  /// 70 to 73.
  void run(int code, std::uint32_t column);
  /// Call when a call was left: restores the state of its M73 and forgets that of its M70.
  void leave_call();

 private:
  struct Kept {
    std::size_t depth = 0;  ///< of calls
    ModalState modal;
    FeedMode feed_mode = FeedMode::per_minute;
    double feed = 0;
    PathControl path_control;
    bool until_return = false;  ///< M73
  };

  /// nullptr if the current call has stored nothing.
  Kept* of_call();
  void forget();
  void restore(const Kept& kept);

  Coordinates& coordinates_;
  std::vector<Kept> kept_;  ///< deepest call last, at most one for each call
};

}  // namespace feedscope::iso
