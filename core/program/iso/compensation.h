#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "core/program/iso/context.h"

namespace feedscope::iso {

/// Runs G40 to G42.1, cutter radius compensation, and keeps the radii that the program gives.
class Compensation : private Part {
 public:
  explicit Compensation(Context& context) : Part(context) {}

  /// D without a G word of compensation, before the G words run: its offset is the one that they use.
  void select_offset();
  /// By ten times the G number.
  void run(int code, std::uint32_t column);
  /// Behind the block's G words: another D or another plane holds from now on.
  void follow_block();
  /// G10 L1 and L10 to L13: radius, or wear on top of it.
  void set_radius(int kind, std::uint32_t column);

 private:
  void begin(std::uint32_t column);
  std::optional<double> radius(int code, std::uint32_t column);

  int code_ = 400;               ///< ten times the G number
  int offset_ = 0;               ///< D in force
  double radius_ = 0;            ///< [mm]
  std::map<int, double> radii_;  ///< given by the program, by offset number [mm]
};

}  // namespace feedscope::iso
