#pragma once

// Room `machine`: machine files. Text becomes a Machine: limits of linear and rotary axes, drives,
// kinematics, work offsets, and the settings of its control, every number with its source. machine_file.h
// reads and writes them, import/ makes them from the configurations of controls, settings.h specifies what
// keys exist.

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

/// Limits of one axis; the units are those of a linear one.
struct AxisLimits {
  double velocity = 0;      ///< [mm/s]
  double acceleration = 0;  ///< [mm/s2]
  double jerk = 0;          ///< [mm/s3]
  double blend_jerk = 0;    ///< on inserted corner blends (Jtb of Essid 2019, table 2) [mm/s3]
  bool operator==(const AxisLimits&) const = default;
};

/// Source of a number in a machine file.
struct Provenance {
  std::string source;    ///< paper and table, or reason for an assumption
  bool assumed = false;  ///< not from a paper
  bool operator==(const Provenance&) const = default;
};

/// A machine tool with its control, as described by one file in machines/.
struct Machine {
  std::string id;
  std::string name;
  std::string control;
  std::string reference;  ///< paper
  std::string model;      ///< default model id
  AxisVector<AxisLimits> axes;
  AxisVector<AxisDrive> drives;  ///< axes without one follow exactly
  MachineKinematics kinematics;  ///< rotary axes; empty: the machine has none
  Settings settings;             ///< control settings of the file, in the units of their keys
  WorkOffsets work_offsets;      ///< of the clamped parts; a program or --offset may give others
  /// Keys as in set_value: "X.jerk", "lookahead_blocks", "G55"; also "kinematics.chain",
  /// "kinematics.A.point".
  std::map<std::string, Provenance, std::less<>> provenance;
  bool operator==(const Machine&) const = default;
};

/// Axis keys of --set and the editor: title, unit and explanation of velocity (m/min), acceleration (m/s2),
/// jerk (m/s3) and blend_jerk (m/s3), each from 1e-6 to 1e9 in its unit. Machine files append the unit:
/// "velocity_m_min".
const std::vector<SettingSpec>& axis_limit_specs();
/// Value in the unit of axis_limit_specs(). Throws InputError for an unknown limit or an axis that the
/// machine lacks.
double axis_limit(const Machine& machine, char axis, std::string_view limit);
/// Sets a limit; a changed value gets the provenance "set by hand". Throws as axis_limit, and if `value` is
/// outside of the bounds of axis_limit_specs().
void set_axis_limit(Machine& machine, char axis, std::string_view limit, double value);

/// Keys of a linear axis for --set and the editor: axis_limit_specs(), then axis_drive_specs().
const std::vector<SettingSpec>& axis_specs();
/// Names of all axes of a machine: X, Y, Z, then its rotary ones.
std::string axis_names(const Machine& machine);
/// axis_specs() or rotary_axis_specs(), depending on the axis.
const std::vector<SettingSpec>& axis_specs_of(char axis);
/// axis_limit(), drive_value() or rotary_value(); an empty text for a missing value. Throws as axis_limit().
SettingValue axis_value(const Machine& machine, char axis, std::string_view key);
/// Sets a value as set_axis_limit() does; an empty text clears a value of a drive. Throws likewise.
void set_axis_value(Machine& machine, char axis, std::string_view key, const SettingValue& value);
/// Throws InputError if the drive of an axis lacks a value that others require (drive_problem()).
void check_drives(const Machine& machine);

/// Key of axis_specs() in a machine file: "velocity" in m/min is "velocity_m_min".
std::string file_key(const SettingSpec& spec);

/// Reads a machine file (TOML). Every number is a table, { value = 20, source = "paper, table" } or { value =
/// 20, assumed = "reason" }; the keys of a drive are optional; a work offset is G55 = { x_mm = 100, y_mm = 0,
/// z_mm = 0, source = "..." }; rotary axes as in read_kinematics(). Throws InputError with file, line,
/// column, key, value, bound and the nearest valid name: unknown or missing key, wrong type, limit out of
/// bounds, number without source, syntax error, unreadable file. `model_settings`: specs beyond
/// common_settings() for [settings]; the one with key "model" has the known models.
Machine read_machine(const std::filesystem::path& file, const std::vector<SettingSpec>& model_settings);
/// Reads a text; `name` replaces the file in messages.
Machine parse_machine(const std::string& text, const std::string& name,
                      const std::vector<SettingSpec>& model_settings);
/// TOML text that read_machine reads back to the same machine, bit for bit.
std::string write_machine(const Machine& machine);

/// Machine files of a folder, sorted by id.
class MachineLibrary {
 public:
  /// Throws InputError if `folder` is not a folder.
  explicit MachineLibrary(std::filesystem::path folder, std::vector<SettingSpec> model_settings);
  const std::vector<std::string>& ids() const { return ids_; }
  /// Loads a machine by id, or by the name of an existing file. Throws InputError with the nearest id
  /// otherwise.
  Machine load(const std::string& id_or_file) const;

 private:
  std::filesystem::path folder_;
  std::vector<SettingSpec> model_settings_;
  std::vector<std::string> ids_;
};

}  // namespace feedscope
