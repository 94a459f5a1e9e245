#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/geometry.h"

namespace feedscope {

/// Zero points of work offsets in the shown coordinates [mm], by the words that call them: "G55", "G54.1 P3",
/// "G505". Given with the program (ReadOptions) or by a machine.
class WorkOffsets {
 public:
  void set(std::string_view name, const Vec3& zero) { zeros_[key(name)] = zero; }
  void erase(std::string_view name) { zeros_.erase(key(name)); }
  void add_missing(const WorkOffsets& other) { zeros_.insert(other.zeros_.begin(), other.zeros_.end()); }
  bool empty() const { return zeros_.empty(); }
  const std::map<std::string, Vec3>& all() const { return zeros_; }
  bool operator==(const WorkOffsets&) const = default;

  /// Canonical name of an offset: "g54.1p03" is "G54.1 P3"; empty for an invalid name.
  static std::string key(std::string_view name);

 private:
  std::map<std::string, Vec3> zeros_;
};

}  // namespace feedscope
