#pragma once

#include <string>

#include "core/machine/import/machine_draft.h"
#include "core/machine/import/section_file.h"

namespace feedscope {

/// LinuxCNC's tables that tilt and turn, xyzac-trt-kins and xyzbc-trt-kins: rotary axes with limits and
/// travel from [AXIS_A] ..., their positions from the HAL commands of the INI file. LinuxCNC counts the
/// rotation of the table, so the tool turns the other way against the part.
class LinuxCncKinematics {
 public:
  /// All references outlive this; `unit` of the machine [mm], "mm" or "inch".
  LinuxCncKinematics(SectionFile& file, MachineDraft& draft, double unit, std::string unit_name)
      : file_(file), draft_(draft), unit_(unit), unit_name_(std::move(unit_name)) {}

  /// Sets the kinematics of the machine if the file names such a table. Otherwise returns false and sets
  /// nothing.
  bool read();

 private:
  /// A pin of the component, as set by HAL commands.
  struct Pin {
    double value = 0;  ///< [mm]
    std::string what;  ///< where and how it is set; empty if it is not
  };

  const SectionEntry* command_for(const std::string& pin) const;
  Pin length(const std::string& pin);
  bool is_on(const std::string& pin) const;
  void add_axis(char name, const Vec3& direction, const Vec3& point, const std::string& source);
  bool set(RotaryAxis& axis, const char* key, double value, const Provenance& source,
           const ConfigurationPlace& place = {});
  void give_limit(RotaryAxis& axis, const char* key, const char* name, const char* unit, double usual,
                  double per_unit);
  void give_travel(RotaryAxis& axis, const char* key, const char* name);

  SectionFile& file_;
  MachineDraft& draft_;
  double unit_;
  std::string unit_name_;
  std::string component_;         ///< "xyzac-trt-kins"
  bool counts_the_table_ = true;  ///< else the rotation of the tool against the part, as ISO 841
};

}  // namespace feedscope
