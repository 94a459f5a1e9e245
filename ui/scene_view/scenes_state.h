#pragma once

#include <QJsonObject>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace feedscope::ui {

/// Number and arrangement of the runs in the 3D part of the window.
enum class ScenesMode : std::uint8_t {
  one,           ///< the current run
  side_by_side,  ///< another one next to it
  split,         ///< the current run left of a line in the view, another one right of it
};

/// State of a 3D comparison of runs in a session; runs by their row.
struct ScenesState {
  ScenesMode mode = ScenesMode::one;
  std::optional<std::size_t> other;      ///< next to the current run; none: the first other one
  double split = 0.5;                    ///< fraction of the view's width left of the line, 0 to 1
  std::optional<std::size_t> reference;  ///< reference of the colours; none: the other one

  bool operator==(const ScenesState&) const = default;
};

QJsonObject to_json(const ScenesState& state);
/// Missing or wrong values leave `state` unchanged.
void read_json(const QJsonObject& json, ScenesState& state);

}  // namespace feedscope::ui
