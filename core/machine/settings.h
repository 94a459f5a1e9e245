#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace feedscope {

/// Override of all feeds of the program, in percent; rapids do not change.
inline constexpr const char* feed_override_key = "feed_override_percent";
/// Default of the setting orientation_tolerance_deg.
inline constexpr double usual_orientation_tolerance_deg = 0.05;

/// One setting for files, command line and editor. The key contains the unit of the value
/// ("interpolation_period_s"), so a Settings value is always in its key's unit; models convert.
struct SettingSpec {
  std::string key = {};
  std::string title = {};        ///< short name for display, without unit
  std::string unit = {};         ///< "" for plain numbers and choices
  std::string explanation = {};  ///< one sentence
  double minimum = 0;
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_allowed = true;            ///< false: the value must exceed `minimum`
  double least_above_zero = 0;            ///< smallest value other than 0
  bool whole = false;                     ///< whole numbers only
  double fallback = 0;                    ///< default without a value from machine or call
  std::vector<std::string> choices = {};  ///< not empty: a text setting whose default is the first choice
  bool optional = false;                  ///< may have no value, an empty text: then it is unknown
};

/// Settings that every model may read: contour_tolerance_mm, program_tolerance, interpolation_period_s,
/// lookahead_blocks, radial_acceleration_share, radial_jerk_share, curvilinear_jerk_m_s3, tangential_share,
/// merge_collinear_mm, block_time_ms and exact_stop_window_um, which are optional; and those of
/// machine_settings(), which apply to every model.
const std::vector<SettingSpec>& common_settings();
/// Settings of a machine that no model of its control requires, each optional: tool_change_time_s,
/// spindle_start_time_s, feed_override_percent, for every axis home_x_mm, tool_change_x_mm, part_zero_x_mm,
/// cutting_feed_x_m_min, tool_length_mm, orientation_tolerance_deg and part_angle_x_deg.
const std::vector<SettingSpec>& machine_settings();

/// Shortest time of a control for a block [ms]; none without it or for 0.
inline constexpr const char* block_time_key = "block_time_ms";

/// Largest velocity in feed moves [m/min] of X, Y or Z, `axis` 0 to 2: "cutting_feed_x_m_min".
std::string cutting_feed_key(int axis);

/// Distance from the set position that the motors must reach before an exact stop ends [um]; without it or
/// for 0 the control does not wait.
inline constexpr const char* exact_stop_window_key = "exact_stop_window_um";

using SettingValue = std::variant<double, std::string>;

/// Control settings of a run by key. Value type; keys sorted.
class Settings {
 public:
  bool has(std::string_view key) const;
  /// Throws InputError naming the key if it is absent or not of this type.
  double number(std::string_view key) const;
  const std::string& text(std::string_view key) const;
  /// Sets a value; an empty text clears it.
  void set(std::string key, SettingValue value);
  /// Value of a setting; an empty text if it has none.
  SettingValue value(std::string_view key) const;
  const std::map<std::string, SettingValue, std::less<>>& values() const { return values_; }
  bool operator==(const Settings&) const = default;

 private:
  std::map<std::string, SettingValue, std::less<>> values_;
};

/// Value of a numeric setting, or the fallback of an optional one without a value.
double number_in_force(const Settings& settings, const SettingSpec& spec);

/// Reads `text` for `spec`, numbers as typed_number(). Throws InputError with key, value, bounds, choices.
SettingValue parse_setting(const SettingSpec& spec, std::string_view text);
/// Throws InputError with key, value and bound if `value` violates `spec`; the message begins with `place`.
void check_setting(const SettingSpec& spec, const SettingValue& value, std::string_view place);
/// Number within the bounds of `spec` nearest to `value`; a number between 0 and the smallest one above 0
/// becomes the latter.
double nearest_within(const SettingSpec& spec, double value);
/// A number for display: 0.000001, not 1e-06.
std::string plain_text(double number);

}  // namespace feedscope
