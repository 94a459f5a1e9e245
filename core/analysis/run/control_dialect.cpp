#include "core/analysis/run/control_dialect.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/analysis/run/run.h"

namespace feedscope {

namespace {

/// A maker or product in the name of a control, and the dialects that such controls read.
struct ControlFamily {
  std::string_view word;  ///< in lower case
  std::array<Dialect, 2> reads;
};

constexpr auto families = std::to_array<ControlFamily>({
    {"sinumerik", {Dialect::sinumerik, Dialect::sinumerik}},
    {"siemens", {Dialect::sinumerik, Dialect::sinumerik}},
    {"heidenhain", {Dialect::heidenhain, Dialect::heidenhain_iso}},
    {"tnc", {Dialect::heidenhain, Dialect::heidenhain_iso}},
    {"fanuc", {Dialect::fanuc, Dialect::fanuc}},
    {"haas", {Dialect::fanuc, Dialect::fanuc}},
    {"mitsubishi", {Dialect::fanuc, Dialect::fanuc}},
    {"linuxcnc", {Dialect::linuxcnc, Dialect::linuxcnc}},
    {"grbl", {Dialect::grbl, Dialect::grbl}},
    {"klipper", {Dialect::grbl, Dialect::grbl}},
    {"marlin", {Dialect::grbl, Dialect::grbl}},
});

/// Shipped machine for each dialect that a published control reads.
struct MachineOfDialect {
  Dialect dialect;
  const char* machine;
};

constexpr auto machines_of_dialects = std::to_array<MachineOfDialect>({
    {Dialect::sinumerik, default_machine},
    {Dialect::heidenhain, "dmg-mori-evo40"},
    {Dialect::heidenhain_iso, "dmg-mori-evo40"},
    {Dialect::grbl, "grbl-router"},
    {Dialect::linuxcnc, "linuxcnc-mill"},
});

const MachineOfDialect* find_machine_of(Dialect dialect) {
  const auto* const found = std::ranges::find(machines_of_dialects, dialect, &MachineOfDialect::dialect);
  return found == machines_of_dialects.end() ? nullptr : found;
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace

std::string default_machine_of(Dialect dialect) {
  const MachineOfDialect* const found = find_machine_of(dialect);
  return found == nullptr ? default_machine : found->machine;
}

std::optional<bool> control_reads(const Machine& machine, Dialect dialect) {
  if (dialect == Dialect::iso) {
    return std::nullopt;
  }
  const std::string control = lower_case(machine.control);
  std::optional<bool> reads;
  for (const ControlFamily& family : families) {
    if (control.find(family.word) != std::string::npos) {
      reads = reads.value_or(false) || std::ranges::find(family.reads, dialect) != family.reads.end();
    }
  }
  return reads;
}

std::optional<ControlMismatch> control_mismatch(const Machine& machine, Dialect dialect) {
  if (control_reads(machine, dialect).value_or(true)) {
    return std::nullopt;
  }
  const MachineOfDialect* const fitting = find_machine_of(dialect);
  return ControlMismatch{dialect, machine.name, machine.control,
                         fitting == nullptr ? std::string() : fitting->machine};
}

Message describe(const ControlMismatch& mismatch) {
  const std::string_view dialect = info_of(mismatch.dialect).title;
  return mismatch.fitting_machine.empty()
             ? message(NC_("core",
                           "The program is written for {}, but {} has a {}: path and times are those of that "
                           "control. No published machine has a {} control; use your own machine file."),
                       dialect, mismatch.machine, mismatch.control, dialect)
             : message(NC_("core",
                           "The program is written for {}, but {} has a {}: path and times are those of that "
                           "control. Use machine {}, whose control reads it."),
                       dialect, mismatch.machine, mismatch.control, mismatch.fitting_machine);
}

}  // namespace feedscope
