#include <fmt/format.h>

#include <memory>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/print.h"
#include "core/analysis/run.h"
#include "core/base/geometry.h"

namespace feedscope {
namespace {

std::string source_text(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  if (found == machine.provenance.end()) {
    return "";
  }
  return (found->second.assumed ? "assumed: " : "") + found->second.source;
}

std::string value_text(const SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

void list_machines() {
  const MachineLibrary library = shipped_machines();
  TextTable table;
  for (const std::string& id : library.ids()) {
    const Machine machine = library.load(id);
    table.add({id, machine.name, machine.control, "model " + machine.model});
  }
  fmt::print("{}", table.text("llll"));
}

void show_machine(const std::string& id) {
  const Machine machine = shipped_machines().load(id);
  fmt::print("{}: {}, {}\n{}\ndefault model: {}\n\n", machine.id, machine.name, machine.control,
             machine.reference, machine.model);
  TextTable table;
  for (const auto& [axis, kind] : machine.axes.axes()) {
    for (const SettingSpec& spec : axis_specs()) {
      const std::string key = fmt::format("{}.{}", axis, spec.key);
      const std::string value = value_text(axis_value(machine, axis, spec.key));
      if (!value.empty()) {
        table.add({key, value, spec.unit, source_text(machine, key)});
      }
    }
  }
  for (const auto& [key, value] : machine.settings.values()) {
    table.add({key, value_text(value), "", source_text(machine, key)});
  }
  fmt::print("{}", table.text("lrll"));
}

}  // namespace

Command add_machines_command(CLI::App& app) {
  const auto id = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("machines", "List the machines, or show one with the source of its numbers");
  command->add_option("ID", *id, "Machine id or machine file");
  return {command, [id] {
            if (id->empty()) {
              list_machines();
            } else {
              show_machine(*id);
            }
            return exit_code::done;
          }};
}

}  // namespace feedscope
