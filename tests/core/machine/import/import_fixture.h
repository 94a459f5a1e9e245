#pragma once

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/diagnostic.h"
#include "core/machine/import/machine_import.h"
#include "core/models/control_model.h"

namespace feedscope::test {

/// Imports texts, as of a file with a name or of files in a folder that goes away with the test.
class ImportTest : public testing::Test {
 protected:
  ImportTest() {
    std::string name = (std::filesystem::temp_directory_path() / "feedscope-import-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~ImportTest() override { std::filesystem::remove_all(folder_); }

  static std::vector<SettingSpec> specs() {
    std::vector<SettingSpec> specs = all_model_settings();
    SettingSpec model;
    model.key = "model";
    for (const ControlModel* known : all_models()) {
      model.choices.push_back(known->info().id);
    }
    specs.push_back(model);
    return specs;
  }

  /// Of a text as a file of that name; what it gives must be a machine file that reads back the same.
  static ImportedMachine import(const std::string& text, const std::string& name) {
    return checked(import_machine_text(text, name, specs()));
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  ImportedMachine import_file(const std::string& name) const {
    return checked(import_machine(folder_ / name, specs()));
  }

  static ImportedMachine checked(ImportedMachine imported) {
    const std::string written = write_machine(imported.machine);
    EXPECT_EQ(parse_machine(written, "written.toml", specs()), imported.machine) << written;
    return imported;
  }

  /// `text` with its first `from` replaced.
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  /// All notes as they are printed.
  static std::string notes(const ImportedMachine& imported, const std::string& file) {
    std::string text;
    for (const Diagnostic& note : imported.notes) {
      text += format(note, file) + "\n";
    }
    return text;
  }
  static std::string source(const ImportedMachine& imported, const std::string& key) {
    const auto found = imported.machine.provenance.find(key);
    return found == imported.machine.provenance.end()
               ? "none"
               : (found->second.assumed ? "assumed: " : "") + found->second.source;
  }

  std::filesystem::path folder_;
};

}  // namespace feedscope::test
