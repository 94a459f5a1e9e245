#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace feedscope::testing {

/// One program on one configuration of a control, as the control's own code runs it.
struct ControlRow {
  std::filesystem::path program;
  std::string configuration;
  double total = 0;            ///< [s]
  std::size_t blocks = 0;      ///< that were run
  std::size_t blend_arcs = 0;  ///< of LinuxCNC: laid in corners
  std::string text;            ///< the row, for messages
};

/// A random program and what tests/oracle/witness makes of it.
struct WitnessRow {
  nlohmann::json configuration;  ///< as in ControlTables::configurations()
  std::string program;
  double seconds = 0;
};

/// Recorded by `compare.py --record`. `control`: "grbl", "klipper".
std::vector<WitnessRow> witness_rows(const std::string& control);

/// The results of controls that lie beside the project, where they do.
class ControlTables {
 public:
  /// `control`: "grbl", "klipper", "linuxcnc".
  explicit ControlTables(const std::string& control);
  /// False: they are not there.
  explicit operator bool() const { return !rows_.empty(); }
  const std::vector<ControlRow>& rows() const { return rows_; }
  const nlohmann::json& configurations() const { return configurations_; }
  static std::filesystem::path folder();
  /// Whether the programs are there that are no samples of the project.
  static bool has_corpus();

 private:
  std::vector<ControlRow> rows_;
  nlohmann::json configurations_;
};

}  // namespace feedscope::testing
