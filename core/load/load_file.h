#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/load/engagement.h"
#include "core/load/material.h"

namespace feedscope {

/// Contents of a load file: engagement of the tools of a program, and custom materials.
struct LoadSetup {
  std::vector<Engagement> operations;
  std::vector<Material> materials;

  bool empty() const { return operations.empty(); }
  bool operator==(const LoadSetup&) const = default;
};

/// Reads a load file (TOML; keys in README.md next to this file). Throws InputError with file, line, key,
/// value and bound: wrong syntax, unknown keys, missing or wrong values, overlapping ranges, an unknown
/// material, no operation at all.
LoadSetup read_load_file(const std::filesystem::path& file);
/// Reads a text; `name` replaces the file in messages. `overlaps`: operations may overlap, as during editing.
LoadSetup parse_load(const std::string& text, const std::string& name, bool overlaps = false);
/// Text that read_load_file() reads back, to the last digit if a number came from a file.
std::string load_file_text(const LoadSetup& setup);

/// Reads the [[material]] tables of a file without operations. Throws InputError likewise.
std::vector<Material> read_materials(const std::filesystem::path& file);

/// Two operations for the same tool and lines, with advice; empty if there are none.
Message overlap_problem(const std::vector<Engagement>& operations);

}  // namespace feedscope
