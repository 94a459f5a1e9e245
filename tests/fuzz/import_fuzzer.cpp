// Any bytes as the configuration of a control: what is made of it is a machine file that reads back the same,
// every number has a source, and notes stand at lines of the text.
#include <algorithm>
#include <cstdint>
#include <string>

#include "core/analysis/run/run.h"
#include "core/base/error.h"
#include "core/machine/import/machine_import.h"
#include "tests/fuzz/must.h"

using namespace feedscope;

namespace {

void check_notes(const ImportedMachine& imported, const std::string& text) {
  const auto lines = static_cast<std::uint32_t>(
      1 + std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; }));
  for (const Diagnostic& note : imported.notes) {
    fuzz::must(note.line <= lines, "line of: " + note.message.english());
    fuzz::must(!note.message.empty() && !note.code.empty(), "empty note");
  }
}

void check_sources(const Machine& machine) {
  for (const auto& [axis, kind] : machine.axes.axes()) {
    for (const char* key : {"velocity", "acceleration", "jerk", "blend_jerk"}) {
      const std::string name = std::string(1, axis) + "." + key;
      fuzz::must(machine.provenance.contains(name), "no source of " + name);
    }
  }
  for (const auto& [key, value] : machine.settings.values()) {
    fuzz::must(machine.provenance.contains(key), "no source of " + key);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<SettingSpec> settings = machine_file_settings();
  const std::string text(data, data + size);
  ImportedMachine imported;
  try {
    imported = import_machine_text(text, "fuzz.cfg", settings);
  } catch (const InputError&) {
    fuzz::must(configuration_kind(text).empty(), "refused");
    return 0;
  }
  fuzz::must(configuration_kind(text) == imported.kind, "kind");
  check_notes(imported, text);
  check_sources(imported.machine);
  const std::string written = write_machine(imported.machine);
  fuzz::must(parse_machine(written, "written.toml", settings) == imported.machine, "written:\n" + written);
  return 0;
}
