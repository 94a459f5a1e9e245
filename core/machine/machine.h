#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/machine/axis_drive.h"
#include "core/machine/axis_vector.h"
#include "core/machine/rotary_axis.h"
#include "core/machine/settings.h"
#include "core/machine/work_offsets.h"

namespace feedscope {

/// Limits of one axis; of a linear one in these units.
struct AxisLimits {
  double velocity = 0;      ///< [mm/s]
  double acceleration = 0;  ///< [mm/s2]
  double jerk = 0;          ///< [mm/s3]
  double blend_jerk = 0;    ///< on inserted corner blends (Jtb of Essid 2019, table 2) [mm/s3]
  bool operator==(const AxisLimits&) const = default;
};

/// Where a number of a machine file comes from.
struct Provenance {
  std::string source;    ///< paper and table, or the reason for an assumption
  bool assumed = false;  ///< no paper gives it
  bool operator==(const Provenance&) const = default;
};

/// A machine tool with its control, as one file in machines/ describes it.
struct Machine {
  std::string id;
  std::string name;
  std::string control;
  std::string reference;  ///< paper
  std::string model;      ///< default model id
  AxisVector<AxisLimits> axes;
  AxisVector<AxisDrive> drives;  ///< an axis that has none here follows exactly
  MachineKinematics kinematics;  ///< rotary axes; empty: the machine has none
  Settings settings;             ///< control settings of the file, in the units of their keys
  WorkOffsets work_offsets;      ///< of the parts that are clamped; a program or --offset may give others
  /// By key as in set_value: "X.jerk", "lookahead_blocks", "G55"; "kinematics.chain",
  /// "kinematics.A.point".
  std::map<std::string, Provenance, std::less<>> provenance;
  bool operator==(const Machine&) const = default;
};

/// Axis keys of --set and the editor: title, unit and explanation of velocity (m/min), acceleration (m/s2),
/// jerk (m/s3) and blend_jerk (m/s3), each from 1e-6 to 1e9 in its unit. Machine files put the unit behind:
/// "velocity_m_min".
const std::vector<SettingSpec>& axis_limit_specs();
/// Value in the unit of axis_limit_specs(). Throws InputError for an axis that the machine does not have, or
/// an unknown limit.
double axis_limit(const Machine& machine, char axis, std::string_view limit);
/// Sets it; a changed value has the provenance "set by hand". Throws as axis_limit, and if `value` is out of
/// the bounds of axis_limit_specs().
void set_axis_limit(Machine& machine, char axis, std::string_view limit, double value);

/// What --set and the editor know of a linear axis: axis_limit_specs(), then axis_drive_specs().
const std::vector<SettingSpec>& axis_specs();
/// Names of all axes of a machine: X, Y, Z, then its rotary ones.
std::string axis_names(const Machine& machine);
/// axis_specs() or rotary_axis_specs(), as this axis is called.
const std::vector<SettingSpec>& axis_specs_of(char axis);
/// Of axis_limit(), drive_value() or rotary_value(): an empty text where an axis has no such value. Throws as
/// axis_limit().
SettingValue axis_value(const Machine& machine, char axis, std::string_view key);
/// Sets it as set_axis_limit() does; an empty text takes the value of a drive back. Throws as that.
void set_axis_value(Machine& machine, char axis, std::string_view key, const SettingValue& value);
/// Throws InputError if the drive of an axis lacks what its other values need (drive_problem()).
void check_drives(const Machine& machine);

/// How a machine file names a key of axis_specs(): "velocity" in m/min is "velocity_m_min".
std::string file_key(const SettingSpec& spec);

/// Reads a machine file (TOML). Every number is a table, { value = 20, source = "paper, table" } or
/// { value = 20, assumed = "reason" }; the keys of a drive may be missing; a work offset is
/// G55 = { x_mm = 100, y_mm = 0, z_mm = 0, source = "..." }; rotary axes as read_kinematics() says.
/// Throws InputError naming file, line, column, key, value, bound and the nearest valid name: unknown or
/// missing key, wrong type, limit out of bounds, number without source, syntax error, unreadable file.
/// `model_settings`: specs beyond common_settings() for [settings]; one of key "model" has the known models.
Machine read_machine(const std::filesystem::path& file, const std::vector<SettingSpec>& model_settings);
/// The same of a text; `name` stands for the file in messages.
Machine parse_machine(const std::string& text, const std::string& name,
                      const std::vector<SettingSpec>& model_settings);
/// As TOML that read_machine reads back to the same machine, bit for bit.
std::string write_machine(const Machine& machine);

/// The machine files of a folder, sorted by id.
class MachineLibrary {
 public:
  /// Throws InputError if `folder` is no folder.
  explicit MachineLibrary(std::filesystem::path folder, std::vector<SettingSpec> model_settings);
  const std::vector<std::string>& ids() const { return ids_; }
  /// By id, or by file name if it names an existing file. Throws InputError with the nearest id otherwise.
  Machine load(const std::string& id_or_file) const;

 private:
  std::filesystem::path folder_;
  std::vector<SettingSpec> model_settings_;
  std::vector<std::string> ids_;
};

}  // namespace feedscope
