#include "tests/core/models/control_tables.h"

#include <fstream>
#include <map>
#include <sstream>

#include "tests/support/folders.h"

namespace feedscope::testing {
namespace {

namespace fs = std::filesystem;

const fs::path shared = fs::path(FEEDSCOPE_SOURCE_DIR) / ".." / "shared";

std::map<std::string, fs::path> corpus_files() {
  std::map<std::string, fs::path> files;
  if (fs::is_directory(shared / "corpus")) {
    for (const auto& entry : fs::recursive_directory_iterator(shared / "corpus")) {
      files.emplace(entry.path().filename().string(), entry.path());
    }
  }
  return files;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) {
    fields.push_back(field);
  }
  return fields;
}

}  // namespace

fs::path ControlTables::folder() {
  return shared / "controls";
}

bool ControlTables::has_corpus() {
  return fs::is_directory(shared / "corpus");
}

std::vector<WitnessRow> witness_rows(const std::string& control) {
  const fs::path file =
      fs::path(FEEDSCOPE_SOURCE_DIR) / "tests" / "core" / "models" / "witness" / (control + ".json");
  std::vector<WitnessRow> rows;
  for (const nlohmann::json& row : nlohmann::json::parse(std::ifstream(file))) {
    rows.push_back({row.at("configuration"), row.at("program"), row.at("seconds")});
  }
  return rows;
}

ControlTables::ControlTables(const std::string& control) {
  std::ifstream table(folder() / (control + ".tsv"));
  std::ifstream configurations(folder() / (control + "_configurations.json"));
  if (!table || !configurations) {
    return;
  }
  configurations_ = nlohmann::json::parse(configurations);
  const std::map<std::string, fs::path> corpus = corpus_files();
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() < 5 || fields[3].empty()) {
      continue;  // not run
    }
    const fs::path sample = fs::path(FEEDSCOPE_SOURCE_DIR) / "resources" / "programs" / fields[0];
    const auto found = corpus.find(fields[0]);
    const fs::path program = fields[1] == "sample" || found == corpus.end() ? sample : found->second;
    constexpr std::size_t blend_arcs = 12;
    const bool has_arcs = control == "linuxcnc" && fields.size() > blend_arcs && !fields[blend_arcs].empty();
    rows_.push_back({program, fields[2], std::stod(fields[3]), std::stoul(fields[4]),
                     has_arcs ? std::stoul(fields[blend_arcs]) : 0, line});
  }
}

}  // namespace feedscope::testing
