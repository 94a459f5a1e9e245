#pragma once

#include <string>

#include "core/machine/import/machine_draft.h"
#include "core/machine/import/section_file.h"

namespace feedscope {

/// The tables of LinuxCNC that tilt and turn, xyzac-trt-kins and xyzbc-trt-kins: rotary axes with limits and
/// travel of [AXIS_A] ..., their places from the HAL commands of the INI file. LinuxCNC counts how the table
/// turns, so that the tool turns against the part the other way.
class LinuxCncKinematics {
 public:
  /// All outlive it; `unit` of the machine [mm], "mm" or "inch".
  LinuxCncKinematics(SectionFile& file, MachineDraft& draft, double unit, std::string unit_name)
      : file_(file), draft_(draft), unit_(unit), unit_name_(std::move(unit_name)) {}

  /// Gives the machine its kinematics where the file names such a table. False, and nothing given, otherwise.
  bool read();

 private:
  /// A pin of the component, as HAL commands set it.
  struct Pin {
    double value = 0;  ///< [mm]
    std::string what;  ///< where and how it is set; empty: nowhere
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
  bool counts_the_table_ = true;  ///< else how the tool turns against the part, as ISO 841
};

}  // namespace feedscope
