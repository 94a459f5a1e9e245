#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace feedscope {

/// Radii of cutters [mm] by the tool's name in the program, however it is written: "7" and "007", "MILL_10"
/// and "mill_10" are the same, with or without quotes. An edge (Sinumerik's D) other than the first one
/// follows a comma: "7,2".
class CutterRadii {
 public:
  /// Does nothing if the name is empty or only an edge: "", ",2".
  void set(std::string_view tool, double radius);
  void erase(std::string_view tool) { radii_.erase(key(tool)); }
  std::optional<double> find(std::string_view tool) const;
  bool empty() const { return radii_.empty(); }
  const std::map<std::string, double>& all() const { return radii_; }
  bool operator==(const CutterRadii&) const = default;

  /// Normal form of a tool's name; a key is its own normal form.
  static std::string key(std::string_view tool);

 private:
  std::map<std::string, double> radii_;
};

}  // namespace feedscope
