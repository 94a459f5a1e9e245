#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/load/engagement.h"
#include "core/load/material.h"

namespace feedscope {

/// What a load file holds: how the tools of a program are engaged, and materials of one's own.
struct LoadSetup {
  std::vector<Engagement> operations;
  std::vector<Material> materials;

  bool empty() const { return operations.empty(); }
  bool operator==(const LoadSetup&) const = default;
};

/// Reads a load file (TOML; keys in README.md beside this file). Throws InputError naming file, line, key,
/// value and bound: wrong syntax, unknown keys, missing or wrong values, ranges that overlap, an unknown
/// material, no operation at all.
LoadSetup read_load_file(const std::filesystem::path& file);
/// The same of a text; `name` stands for the file in messages. `overlaps`: operations may overlap, as while
/// someone edits them.
LoadSetup parse_load(const std::string& text, const std::string& name, bool overlaps = false);
/// The text of a load file that read_load_file() reads as this, to the last digit where a number came from a
/// file.
std::string load_file_text(const LoadSetup& setup);

/// Reads the [[material]] tables of a file without operations. Throws InputError as above.
std::vector<Material> read_materials(const std::filesystem::path& file);

/// Two operations that apply to the same tool and lines, and what to do; empty if there are none.
Message overlap_problem(const std::vector<Engagement>& operations);

}  // namespace feedscope
