#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "core/program/iso/context.h"

namespace feedscope::iso {

/// Runs G40 to G42.1, cutter radius compensation, and stores the radii that the program gives.
class Compensation : private Part {
 public:
  explicit Compensation(Context& context) : Part(context) {}

  /// Applies D without a G word of compensation, before the G words run, because they use its offset.
  void select_offset();
  /// By ten times the G number.
  void run(int code, std::uint32_t column);
  /// After the block's G words: brings another D or another plane into force.
  void follow_block();
  /// G10 L1 and L10 to L13: radius, or wear added to it.
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
