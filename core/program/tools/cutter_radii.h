#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// Radii of cutters [mm] by the tool that a program names, however it writes it: "7" and "007", "MILL_10" and
/// "mill_10" are one, with or without quotes. An edge (Sinumerik's D) other than the first one stands behind
/// a comma: "7,2".
class CutterRadii {
 public:
  /// No effect where nothing is left of the name, or only an edge: "", ",2".
  void set(std::string_view tool, double radius);
  void erase(std::string_view tool) { radii_.erase(key(tool)); }
  std::optional<double> find(std::string_view tool) const;
  bool empty() const { return radii_.empty(); }
  const std::map<std::string, double>& all() const { return radii_; }
  bool operator==(const CutterRadii&) const = default;

  /// The one way to write a tool; that of a key is itself.
  static std::string key(std::string_view tool);

 private:
  std::map<std::string, double> radii_;
};

}  // namespace feedscope
