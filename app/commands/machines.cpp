#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/print.h"
#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/machine/import/machine_import.h"
#include "core/machine/key_unit.h"
#ifdef FEEDSCOPE_WITH_UI
#include "app/commands/language_option.h"
#include "ui/report/kinematics_picture.h"
#endif

namespace feedscope {
namespace {

constexpr const char* import_word = "import";

std::string source_text(const Machine& machine, const std::string& key) {
  const auto found = machine.provenance.find(key);
  if (found == machine.provenance.end()) {
    return "";
  }
  return (found->second.assumed ? "assumed: " : "") + found->second.source;
}

/// Seven digits: more are those of a conversion, such as 2 (m/min)/mm in 1/s.
std::string value_text(const SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", std::stod(fmt::format("{:.7g}", *number)))
                           : std::get<std::string>(value);
}

/// Unit of a key, and for a value that data sheets often give in another unit, the value in that: "m/s2 =
/// 0.51 g".
std::string unit_text(const SettingValue& value, const std::string& unit) {
  const DataSheetUnit other = data_sheet_unit(unit);
  const double* number = std::get_if<double>(&value);
  return number == nullptr || other.name.empty()
             ? unit
             : fmt::format("{} = {:.4g} {}", unit, *number / other.factor, other.name);
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

/// Adds the order of the axes from part to tool, and the lines about which the rotary ones turn.
void add_kinematics(const Machine& machine, TextTable& table) {
  if (machine.kinematics.empty()) {
    return;
  }
  const auto add = [&](const std::string& key, const std::string& value, const std::string& unit) {
    table.add({key, value, unit, source_text(machine, key)});
  };
  const auto numbers = [](const Vec3& v) { return fmt::format("{}, {}, {}", v.x(), v.y(), v.z()); };
  add("kinematics.chain", machine.kinematics.chain, "");
  if (machine.kinematics.tool_length) {
    add("kinematics.tool_length", fmt::format("{}", *machine.kinematics.tool_length), "mm");
  }
  for (const RotaryAxis& axis : machine.kinematics.rotary) {
    const std::string key = fmt::format("kinematics.{}.", axis.name);
    add(key + "direction", numbers(axis.direction), "");
    add(key + "point", numbers(axis.point), "mm");
  }
}

void show_machine(const std::string& id) {
  const Machine machine = shipped_machines().load(id);
  fmt::print("{}: {}, {}\n{}\ndefault model: {}\n\n", machine.id, machine.name, machine.control,
             machine.reference, machine.model);
  TextTable table;
  for (const char axis : axis_names(machine)) {
    for (const SettingSpec& spec : axis_specs_of(axis)) {
      const std::string key = fmt::format("{}.{}", axis, spec.key);
      const SettingValue value = axis_value(machine, axis, spec.key);
      if (const std::string text = value_text(value); !text.empty()) {
        table.add({key, text, unit_text(value, spec.unit), source_text(machine, key)});
      }
    }
  }
  add_kinematics(machine, table);
  for (const auto& [key, value] : machine.settings.values()) {
    table.add({key, value_text(value), "", source_text(machine, key)});
  }
  fmt::print("{}", table.text("lrll"));
}

struct MachinesOptions {
  std::string id;
  std::string file;
  std::string out;
  std::string picture;
  std::string language;  ///< of the picture
};

/// Imports a file, or standard input for "-", which includes no other files.
ImportedMachine import_from(const std::string& file) {
  if (file != "-") {
    return import_machine(file, machine_file_settings());
  }
  const std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  return import_machine_text(text, "standard-input", machine_file_settings());
}

/// Writes a machine file from the configuration of a control; reports values that are missing there.
int import_configuration(const MachinesOptions& options) {
  const std::string out = options.out.empty() ? "-" : options.out;
  check_outputs(options.file, {out}, "the file that is imported");
  ImportedMachine imported = import_from(options.file);
  if (out != "-") {
    imported.machine.id = std::filesystem::path(out).stem().string();
  }
  OutputFile file(out);
  file.stream() << write_machine(imported.machine);
  file.commit();
  print_diagnostics(imported.notes, options.file);
  if (out != "-") {
    const auto assumed = std::ranges::count_if(imported.machine.provenance,
                                               [](const auto& one) { return one.second.assumed; });
    fmt::print("{} -> {}: {} numbers from the {}, {} assumed; see: feedscope machines {}\n", options.file,
               out, static_cast<std::ptrdiff_t>(imported.machine.provenance.size()) - assumed, imported.kind,
               assumed, out);
  }
  return has_errors(imported.notes) ? exit_code::program_errors : exit_code::done;
}

#ifdef FEEDSCOPE_WITH_UI
/// Draws the machine's kinematics instead of printing its numbers.
void draw_machine(const MachinesOptions& options) {
  const Machine machine = shipped_machines().load(options.id);
  OutputFile file(options.picture);
  file.stream() << ui::kinematics_picture(options.picture, machine, QString::fromStdString(options.language));
  file.commit();
}
#endif

int run_machines(const MachinesOptions& options) {
  if (!options.picture.empty() && (options.id.empty() || options.id == import_word)) {
    throw InputError("--picture needs a machine: write feedscope machines ID --picture FILE.png");
  }
  if (options.id == import_word) {
    if (options.file.empty()) {
      throw InputError("machines import needs a FILE: the configuration of a control");
    }
    return import_configuration(options);
  }
  if (!options.file.empty() || !options.out.empty()) {
    throw InputError(
        fmt::format("'{}' is only known with import: write feedscope machines import FILE --out machine.toml",
                    options.file.empty() ? "--out" : options.file));
  }
#ifdef FEEDSCOPE_WITH_UI
  if (!options.picture.empty()) {
    draw_machine(options);
    return exit_code::done;
  }
#endif
  if (options.id.empty()) {
    list_machines();
  } else {
    show_machine(options.id);
  }
  return exit_code::done;
}

}  // namespace

Command add_machines_command(CLI::App& app) {
  const auto options = std::make_shared<MachinesOptions>();
  CLI::App* command = app.add_subcommand(
      "machines",
      "List the machines, show one with the source of its numbers, or import the configuration of a control");
  command->add_option("ID", options->id, "Machine id or machine file; import: make a machine file from FILE");
  command->add_option(
      "FILE", options->file,
      "With import: INI file of LinuxCNC, listing of grbl ($$) or Marlin (M503), printer.cfg of "
      "Klipper, machine data of a Sinumerik, parameters of a Fanuc or Heidenhain");
  command->add_option("--out", options->out, "Machine file that import writes [standard output]")
      ->type_name("FILE.toml");
#ifdef FEEDSCOPE_WITH_UI
  CLI::Option* picture =
      command
          ->add_option(
              "--picture", options->picture,
              "Draw the kinematics of a machine with rotary axes: axes, positive directions, points, chain")
          ->type_name("FILE.png|svg|pdf");
  add_language_option(*command, options->language);
  command->get_option("--language")->needs(picture);
#endif
  command->footer("Example: feedscope machines import printer.cfg --out printer.toml");
  return {command, [options] { return run_machines(*options); }};
}

}  // namespace feedscope
