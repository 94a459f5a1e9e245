#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/base/geometry.h"

namespace feedscope {

/// Zero points of work offsets in the coordinates that are shown [mm], by the words that call them: "G55",
/// "G54.1 P3", "G505".
class WorkOffsets {
 public:
  void set(std::string_view name, const Vec3& zero) { zeros_[key(name)] = zero; }
  void erase(std::string_view name) { zeros_.erase(key(name)); }
  bool empty() const { return zeros_.empty(); }
  const std::map<std::string, Vec3>& all() const { return zeros_; }
  bool operator==(const WorkOffsets&) const = default;

  /// The one way to write an offset: "g54.1p03" is "G54.1 P3"; empty for what names none.
  static std::string key(std::string_view name);

 private:
  std::map<std::string, Vec3> zeros_;
};

/// A work offset that a program calls.
struct OffsetUse {
  std::string name;          ///< as a key of WorkOffsets
  std::uint32_t line = 0;    ///< of its first use
  std::uint64_t blocks = 0;  ///< motions while it is in force
  bool given = false;        ///< the program or ReadOptions give its zero point; else it is taken as zero
};

}  // namespace feedscope
