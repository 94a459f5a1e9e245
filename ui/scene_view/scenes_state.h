#pragma once

#include <QJsonObject>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace feedscope::ui {

/// How many runs the 3D part of the window shows, and where.
enum class ScenesMode : std::uint8_t {
  one,           ///< the current run
  side_by_side,  ///< another one beside it
  split,         ///< the current run left of a line across the view, another one right of it
};

/// What a session keeps of runs that are compared in 3D; runs by their row.
struct ScenesState {
  ScenesMode mode = ScenesMode::one;
  std::optional<std::size_t> other;      ///< beside the current run; none: the first other one
  double split = 0.5;                    ///< share of the view's width left of the line, 0 to 1
  std::optional<std::size_t> reference;  ///< that the colours compare with; none: the other one

  bool operator==(const ScenesState&) const = default;
};

QJsonObject to_json(const ScenesState& state);
/// What is missing or wrong stays as it is in `state`.
void read_json(const QJsonObject& json, ScenesState& state);

}  // namespace feedscope::ui
