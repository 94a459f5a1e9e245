#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/models/grbl/grbl_settings.h"

namespace feedscope {

/// Cause of GrblBlock::max_entry_squared.
enum class GrblEntry : std::uint8_t { rest, junction, own_speed, speed_before };

/// A straight block in grbl's plan; mm and minutes.
struct GrblBlock {
  float entry_squared = 0;      ///< planned entry speed squared [mm2/min2]
  float max_entry_squared = 0;  ///< upper limit of entry_squared [mm2/min2]
  float acceleration = 0;       ///< [mm/min2]
  float nominal = 0;            ///< largest speed [mm/min]
  float left = 0;               ///< length that is not yet prepared [mm]
  std::array<std::uint32_t, 3> steps{};
  std::uint32_t step_count = 0;  ///< of the axis with the most steps; 0 without steps
  std::uint32_t id = 0;          ///< number of its segment
  std::int8_t acceleration_axis = -1;
  std::int8_t speed_axis = -1;  ///< axis that limits the nominal speed; -1: the programmed feed does
  GrblEntry entry = GrblEntry::rest;
};

/// Begin or end of a line: machine coordinates as stored between blocks.
struct GrblPlace {
  std::array<std::int32_t, 3> steps{};
  std::array<float, 3> mm{};  ///< without steps
};

/// Blocks in grbl's look-ahead, and their entry speeds (README.md, "Planning").
class GrblPlanner {
 public:
  explicit GrblPlanner(const GrblSettings& settings);

  /// Sets the position of the tool, with an empty queue.
  void set_place(const std::array<float, 3>& mm);
  const GrblPlace& place() const { return place_; }

  bool empty() const { return blocks_.empty(); }
  bool full() const { return blocks_.size() >= settings_.buffer_blocks; }
  std::size_t size() const { return blocks_.size(); }
  GrblBlock& front() { return blocks_.front(); }
  const GrblBlock& operator[](std::size_t i) const { return blocks_[i]; }

  struct Line {
    std::array<float, 3> target{};  ///< [mm]
    float feed = 0;                 ///< [mm/min]
    bool rapid = false;
    std::uint32_t id = 0;  ///< as GrblBlock::id
  };
  /// Queues a line. `running_speed`: of the front block, if it is being prepared [mm/min]. Returns false if
  /// the line makes no step.
  bool add(const Line& line, std::optional<float> running_speed);
  /// True if the last add() recomputed the plan back to the front block: if that is being prepared, it begins
  /// again from its running speed.
  bool reached_front() const { return reached_front_; }

  /// Exit speed squared of the front block [mm2/min2].
  float exit_squared() const { return blocks_.size() > 1 ? blocks_[1].entry_squared : 0; }
  /// Removes the front block, which is prepared to its end.
  void pop();

 private:
  void replan(std::optional<float> running_speed);

  const GrblSettings& settings_;
  std::deque<GrblBlock> blocks_;
  std::size_t planned_ = 0;  ///< first block whose entry speed is final
  GrblPlace place_;
  std::array<float, 3> direction_before_{};  ///< of the last queued block
  float nominal_before_ = 0;                 ///< of the last queued block [mm/min]
  bool reached_front_ = false;
};

}  // namespace feedscope
