#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/machine/machine.h"

/// Common parts of the JSON files; only for the sources of this folder, so that no other header needs the
/// library.
namespace feedscope {

using Json = nlohmann::ordered_json;

struct ComparedRun;
struct Run;

/// Beginning of a file of this kind. The version increases when a key is removed or changes its meaning.
Json with_format(const char* kind);
/// Null for NaN and infinity, which JSON does not have.
Json finite(double value);
Json settings_values(const Settings& settings);
/// Values of the drives by axis, keys as in machine files; null if all axes follow exactly.
Json drives_json(const Machine& machine);
/// Cutting load of a run; null without a load file.
Json load_json(const ComparedRun& run);
/// Beginning of files about one run, `program` and the figures of the run, and their end: `diagnostics` and
/// `elapsed`.
Json run_head_json(const Run& run, const ComparedRun& figures);
Json run_end_json(const Run& run, const ComparedRun& figures);
/// Indented text with a newline at the end; invalid UTF-8 is shown with replacement characters.
std::string text_of(const Json& json);

}  // namespace feedscope
