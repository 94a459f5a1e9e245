#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "tests/contract/random.h"

namespace feedscope::contract {

/// Writes one random NC program, block by block.
class RandomProgram {
 public:
  explicit RandomProgram(Random& random);
  std::vector<std::string> lines();

 private:
  /// Axes of a plane: the turn goes from `a` to `b` about `normal`.
  struct Plane {
    int code, a, b, normal;
  };

  void add_block();
  void turn();
  void add_line(const char* code, const Vec3& target);
  void add_arc();
  void add_dwell();
  std::string feed_word();
  std::string rounded(double value) const;
  Vec3 random_direction();
  void set_sizes();

  Random& random_;
  std::vector<std::string> lines_;
  Vec3 at_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitX();
  double size_ = 1;  ///< of a block [mm]
  double feed_ = 0;  ///< [mm/min]
  bool feed_changed_ = true;
  int decimals_;
  double arc_share_;
  double wildness_;  ///< of turns; 0: any
  double change_share_;
};

}  // namespace feedscope::contract
