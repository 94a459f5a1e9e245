#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/program/iso/context.h"
#include "core/program/iso/geometry/frames.h"
#include "core/program/iso/geometry/targets.h"

namespace feedscope::iso {

/// Runs the G words that set coordinates: work offsets, shifts, rotation, scale, mirror image. They change
/// the path's frame at once.
class Coordinates : private Part {
 public:
  /// Both outlive it. Work offsets of ReadOptions are in force from the start.
  Coordinates(Context& context, const Targets& targets);

  /// G50 to G52, G54 to G59.3, G68, G69, G92 and similar, by ten times the G number.
  void run(int code, std::uint32_t column);
  /// G10 L2 and L20: sets a work offset.
  void set_work_offset(bool further, std::uint32_t column);
  void preset_work_offset(std::uint32_t column);
  /// Brings a work offset into force as M72 restores it.
  void restore_work_offset(int key);

  /// Coordinate of a work offset [mm]; none if the program and ReadOptions do not give it.
  std::optional<double> offset_coordinate(int key, int axis) const;
  void set_offset_coordinate(int key, int axis, double value);

 private:
  bool run_frame_code(int code, std::uint32_t column);
  void set_position(std::uint32_t column);
  void set_frame();
  void use_given_offsets();
  void select_work_offset(int code, std::uint32_t column);
  void use_work_offset(int key);
  std::optional<int> offset_key(std::uint32_t column, bool further) const;
  Frames::WorkOffset offset_or_zero(int key) const;
  void store_work_offset(int key, const Frames::WorkOffset& offset);
  void rotate(std::uint32_t column);
  void rotate_in_space(std::uint32_t column);
  void tilt(std::uint32_t column);
  void report_tilt(std::uint32_t column) const;
  void check_turning(std::uint32_t column) const;
  double scale_factor(const Word& word) const;
  void scale(std::uint32_t column);
  void mirror(bool on);

  const Targets& targets_;
  Frames frames_;
};

}  // namespace feedscope::iso
