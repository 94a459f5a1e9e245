#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace feedscope {

/// All feeds of the program, in percent of what it says; rapids stay.
inline constexpr const char* feed_override_key = "feed_override_percent";
/// Of the setting orientation_tolerance_deg where it is not given.
inline constexpr double usual_orientation_tolerance_deg = 0.05;

/// One setting as files, command line and editor show it. The key carries the unit of the value
/// ("interpolation_period_s"), so a Settings value is always in its key's unit; models convert.
struct SettingSpec {
  std::string key = {};
  std::string title = {};        ///< short name for people, without unit
  std::string unit = {};         ///< "" for plain numbers and choices
  std::string explanation = {};  ///< one sentence
  double minimum = 0;
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_allowed = true;            ///< false: the value must exceed `minimum`
  double least_above_zero = 0;            ///< a value above 0 must be at least this
  bool whole = false;                     ///< whole numbers only
  double fallback = 0;                    ///< where neither machine nor call give a value
  std::vector<std::string> choices = {};  ///< not empty: a text setting, first choice is the fallback
  bool optional = false;                  ///< may have no value, an empty text: then it is not known
};

/// Settings that every model may read: contour_tolerance_mm, program_tolerance, interpolation_period_s,
/// lookahead_blocks, radial_acceleration_share, radial_jerk_share, curvilinear_jerk_m_s3, tangential_share,
/// merge_collinear_mm, block_time_ms and exact_stop_window_um, which are optional; and those of
/// machine_settings(), which hold for every model.
const std::vector<SettingSpec>& common_settings();
/// What of a machine no model of its control needs, each optional: tool_change_time_s, spindle_start_time_s,
/// feed_override_percent, of every axis home_x_mm, tool_change_x_mm, part_zero_x_mm, cutting_feed_x_m_min,
/// tool_length_mm,
/// orientation_tolerance_deg and part_angle_x_deg.
const std::vector<SettingSpec>& machine_settings();

/// Time that a control takes for a block at least [ms]; without it, or 0, none.
inline constexpr const char* block_time_key = "block_time_ms";

/// Largest velocity in feed moves [m/min] of X, Y or Z, `axis` 0 to 2: "cutting_feed_x_m_min".
std::string cutting_feed_key(int axis);

/// Distance from the set position within which the motors must be before an exact stop ends [um]; without it,
/// or 0, the control waits for none.
inline constexpr const char* exact_stop_window_key = "exact_stop_window_um";

using SettingValue = std::variant<double, std::string>;

/// Control settings of a run by key. Value type; keys sorted.
class Settings {
 public:
  bool has(std::string_view key) const;
  /// Throws InputError naming the key if it is absent or not of this type.
  double number(std::string_view key) const;
  const std::string& text(std::string_view key) const;
  /// An empty text takes the value back.
  void set(std::string key, SettingValue value);
  /// An empty text if it has none.
  SettingValue value(std::string_view key) const;
  const std::map<std::string, SettingValue, std::less<>>& values() const { return values_; }
  bool operator==(const Settings&) const = default;

 private:
  std::map<std::string, SettingValue, std::less<>> values_;
};

/// Of a setting with numbers: its value, or the fallback where an optional one has none.
double number_in_force(const Settings& settings, const SettingSpec& spec);

/// Reads `text` for `spec`, numbers as typed_number(). Throws InputError naming key, value, bounds, choices.
SettingValue parse_setting(const SettingSpec& spec, std::string_view text);
/// Throws InputError naming key, value and bound if `value` breaks `spec`; `place` is put in front.
void check_setting(const SettingSpec& spec, const SettingValue& value, std::string_view place);
/// The number from the least to the largest of `spec` that is nearest to `value`; too small a one above 0
/// becomes the least above 0.
double nearest_within(const SettingSpec& spec, double value);
/// A number for people: 0.000001, not 1e-06.
std::string plain_text(double number);

}  // namespace feedscope
