#include "core/analysis/load/load_sample.h"

#include <array>

namespace feedscope {
namespace {

constexpr std::array<std::string_view, load_state_count> state_keys{"cutting",      "rapid",  "dwell",
                                                                    "no_operation", "plunge", "no_spindle"};

}  // namespace

std::string_view key_of(LoadState state) {
  return state_keys[static_cast<std::size_t>(state)];
}

}  // namespace feedscope
