#include "core/machine/import/klipper_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/nearest_name.h"
#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/machine_draft.h"
#include "core/machine/import/section_file.h"

namespace feedscope {
namespace {

std::size_t recognised_klipper(std::string_view text) {
  constexpr std::array whole{"printer", "mcu", "extruder", "heater_bed", "virtual_sdcard", "gcode_arcs"};
  constexpr std::array begun{"stepper_", "gcode_macro ", "include ", "tmc2", "mcu ", "heater_fan "};
  std::size_t count = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    if (line.text.size() > 2 && line.text.front() == '[' && line.text.find(']') != std::string_view::npos) {
      const std::string_view name = line.text.substr(1, line.text.find(']') - 1);
      count += std::ranges::find(whole, name) != whole.end() ||
                       std::ranges::any_of(begun, [&](const char* one) { return name.starts_with(one); })
                   ? 1
                   : 0;
    }
  }
  return count;
}

class KlipperReader {
 public:
  KlipperReader(const ConfigurationSource& source, MachineDraft draft)
      : draft_(std::move(draft)), file_(source, SectionStyle::klipper, draft_) {}

  ImportedMachine read() {
    Machine& machine = draft_.machine();
    machine.control = "Klipper";
    machine.reference = fmt::format("{}, configuration of the machine's Klipper", draft_.file());
    draft_.choose_model({"klipper"});
    if (file_.find_section("printer") == nullptr) {
      draft_.note(Severity::error, {}, "section-missing",
                  NC_("core", "section [printer] is missing; its limits are assumed"),
                  NC_("core", "import the file that Klipper itself reads, printer.cfg"));
    }
    read_path_limits();
    read_z_limits();
    read_corners();
    read_arcs();
    read_extruder();
    note_kinematics();
    note_what_is_not_modelled();
    file_.leave_out_rest();
    return draft_.finish(klipper_config.kind, {18, 3, 0});
  }

 private:
  /// A number of [printer]; a value that Klipper itself would refuse is an error in the notes.
  std::optional<double> printer(const char* key, const char* unit = "", double above = 0) {
    const SectionEntry* entry = file_.find("printer", key);
    const std::optional<double> value =
        entry == nullptr ? std::nullopt : draft_.number(entry->value, entry->given(unit));
    if (value && *value <= above) {
      draft_.note(Severity::error, entry->place, "limit-out-of-bounds",
                  message(NC_("core", "{} must be above {}: Klipper does not start with it"),
                          entry->given(unit).what, above));
      return std::nullopt;
    }
    return value;
  }

  GivenValue given(const char* key, const char* unit = "") { return file_.find("printer", key)->given(unit); }

  void read_path_limits() {
    if (const std::optional<double> velocity = printer("max_velocity", "mm/s")) {
      draft_.give("max_velocity_m_min", units::to_m_min(*velocity), given("max_velocity", "mm/s"));
      give_plane("velocity", units::to_m_min(*velocity), given("max_velocity", "mm/s"));
    }
    if (const std::optional<double> acceleration = printer("max_accel", "mm/s2")) {
      draft_.give("max_acceleration_m_s2", units::to_m(*acceleration), given("max_accel", "mm/s2"));
      give_plane("acceleration", units::to_m(*acceleration), given("max_accel", "mm/s2"));
    }
  }

  void give_plane(const char* key, double value, const GivenValue& from) {
    draft_.give_axis('X', key, value, from);
    draft_.give_axis('Y', key, value, from);
  }

  void read_z_limits() {
    read_z("max_z_velocity", "max_velocity", "mm/s", "velocity", "max_z_velocity_m_min", units::to_m_min);
    read_z("max_z_accel", "max_accel", "mm/s2", "acceleration", "max_z_acceleration_m_s2", units::to_m);
  }

  void read_z(const char* name, const char* path_name, const char* unit, const char* key, const char* setting,
              double (*to_unit)(double)) {
    const std::optional<double> value = printer(name, unit);
    const SectionEntry* path = file_.find("printer", path_name);
    const std::optional<double> most =
        path == nullptr ? std::nullopt : draft_.number(path->value, path->given(unit));
    if (value && most && *value > *most) {
      draft_.note(Severity::error, file_.find("printer", name)->place, "limits-contradict",
                  message(NC_("core", "{} exceeds {} = {} ({}): Klipper does not start with it"),
                          given(name, unit).what, std::string_view(path_name), path->value,
                          draft_.place_text(path->place)),
                  message(NC_("core", "lower {}"), std::string_view(name)));
    }
    if (value) {
      draft_.give_axis('Z', key, to_unit(*value), given(name, unit));
      draft_.give(setting, to_unit(*value), given(name, unit));
    }
  }

  void read_corners() {
    if (const std::optional<double> velocity = printer("square_corner_velocity", "mm/s", -1e-9)) {
      draft_.give("square_corner_velocity_mm_s", *velocity, given("square_corner_velocity", "mm/s"));
    } else {
      assume_default("square_corner_velocity_mm_s", 5, "square_corner_velocity");
    }
    const std::optional<double> ratio = printer("minimum_cruise_ratio", "", -1e-9);
    const std::optional<double> decel = printer("max_accel_to_decel", "mm/s2");
    const std::optional<double> acceleration = printer("max_accel", "mm/s2");
    if (ratio) {
      draft_.give("minimum_cruise_ratio", *ratio, given("minimum_cruise_ratio"));
    } else if (decel && acceleration) {
      // Conversion of the former setting in newer releases of Klipper.
      GivenValue from = given("max_accel_to_decel", "mm/s2");
      from.what += fmt::format(" as minimum cruise ratio, with max_accel = {}", *acceleration);
      draft_.give("minimum_cruise_ratio", 1 - std::min(1.0, *decel / *acceleration), from);
    } else {
      assume_default("minimum_cruise_ratio", 0.5, "minimum_cruise_ratio");
    }
  }

  void assume_default(const char* key, double value, const char* name) {
    draft_.assume(key, value, fmt::format("{} does not give {}: default of Klipper", draft_.file(), name));
  }

  void read_arcs() {
    const SectionEntry* entry = file_.find("gcode_arcs", "resolution");
    const std::optional<double> length =
        entry == nullptr ? std::nullopt : draft_.number(entry->value, entry->given("mm"));
    if (length) {
      draft_.give("arc_resolution_mm", *length, entry->given("mm"));
    } else {
      assume_default("arc_resolution_mm", 1, "resolution of [gcode_arcs]");
    }
    if (file_.find_section("gcode_arcs") == nullptr) {
      draft_.note(Severity::warning, {}, "no-arcs",
                  NC_("core",
                      "there is no section [gcode_arcs]: this Klipper does not know G2 and G3, while the "
                      "model runs them"),
                  NC_("core", "add [gcode_arcs], or let the CAM system write lines"));
    }
  }

  std::optional<double> extruder(const char* key) {
    const SectionEntry* entry = file_.find("extruder", key);
    return entry == nullptr ? std::nullopt : draft_.number(entry->value, entry->given());
  }

  /// Limits of the extruder alone: as given, or Klipper's share of those along the path, which needs the
  /// diameters of nozzle and filament, or the largest extrusion cross section.
  void read_extruder() {
    const std::optional<double> nozzle = extruder("nozzle_diameter");
    const std::optional<double> filament = extruder("filament_diameter");
    const std::optional<double> section = extruder("max_extrude_cross_section");
    std::optional<double> share;
    if (filament && *filament > 0 && (section || nozzle)) {
      share = section.value_or(4 * nozzle.value_or(0) * nozzle.value_or(0)) /
              (units::pi / 4 * *filament * *filament);
    }
    give_extruder("max_extrude_only_velocity", "max_extrude_velocity_mm_s", "mm/s", units::as_it_is,
                  "max_velocity", share);
    give_extruder("max_extrude_only_accel", "max_extrude_acceleration_m_s2", "mm/s2", units::to_m,
                  "max_accel", share);
  }

  void give_extruder(const char* name, const char* setting, const char* unit, double (*to_unit)(double),
                     const char* path_name, const std::optional<double>& share) {
    const SectionEntry* entry = file_.find("extruder", name);
    const SectionEntry* path = file_.find("printer", path_name);
    if (entry != nullptr) {
      if (const std::optional<double> value = draft_.number(entry->value, entry->given(unit))) {
        draft_.give(setting, to_unit(*value), entry->given(unit));
      }
    } else if (const std::optional<double> most =
                   path == nullptr ? std::nullopt : draft_.number(path->value, path->given(unit));
               most && share) {
      draft_.assume(setting, to_unit(*share * *most),
                    fmt::format("{} does not give {}: default of Klipper for its nozzle and filament",
                                draft_.file(), name));
    }
  }

  void note_kinematics() {
    const SectionEntry* entry = file_.find("printer", "kinematics");
    constexpr std::array known{"cartesian", "corexy", "corexz", "hybrid_corexy", "hybrid_corexz"};
    if (entry != nullptr && std::ranges::find(known, entry->value) == known.end()) {
      draft_.note(
          Severity::warning, entry->place, "not-modelled",
          message(
              NC_("core", "kinematics {} are not modelled: limits hold along the path, and those of Z alone"),
              entry->value));
    }
    if (entry != nullptr) {
      draft_.machine().name = fmt::format("{} ({})", draft_.machine().name, entry->value);
    }
  }

  void note_what_is_not_modelled() {
    const std::vector<std::string> used{"max_velocity",           "max_accel",
                                        "max_z_velocity",         "max_z_accel",
                                        "square_corner_velocity", "minimum_cruise_ratio",
                                        "max_accel_to_decel",     "kinematics"};
    for (const SectionEntry& entry : file_.entries()) {
      if (entry.section != "printer" || std::ranges::find(used, entry.key) != used.end()) {
        continue;
      }
      if (const std::string nearest = nearest_name(entry.key, used); !nearest.empty()) {
        draft_.note(Severity::warning, entry.place, "not-understood",
                    message(NC_("core", "[printer] {} is not used here; skipped"), entry.key),
                    message(NC_("core", "did you mean '{}'?"), nearest));
      }
    }
    for (const SectionHead& head : file_.sections()) {
      if (head.name == "input_shaper") {
        draft_.note(
            Severity::info, head.place, "not-modelled",
            NC_("core",
                "input shaping is not modelled: it smooths the motion and takes no longer on the whole"));
      }
    }
  }

  MachineDraft draft_;
  SectionFile file_;
};

ImportedMachine read_klipper(const ConfigurationSource& source, MachineDraft draft) {
  return KlipperReader(source, std::move(draft)).read();
}

}  // namespace

const ConfigurationFormat klipper_config{QT_TRANSLATE_NOOP("core", "configuration of Klipper"),
                                         recognised_klipper, read_klipper};

}  // namespace feedscope
