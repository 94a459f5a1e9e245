#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/machine/machine.h"

/// What the JSON files have in common; for the sources of this folder alone, so that no other header needs
/// the library.
namespace feedscope {

using Json = nlohmann::ordered_json;

struct ComparedRun;
struct LoadedProgram;

/// What a file of this kind begins with. The version grows when a key goes or changes its meaning.
Json with_format(const char* kind);
/// JSON knows no NaN and no infinity: null where there is no number.
Json finite(double value);
Json settings_values(const Settings& settings);
/// By axis what its drive has, keys as in machine files; null where all follow exactly.
Json drives_json(const Machine& machine);
/// The cutting load of a run; null without a load file.
Json load_json(const ComparedRun& run);
/// What files about one run begin with, `program` and the figures of the run, and what they end with:
/// `diagnostics` and `elapsed`.
Json run_head_json(const LoadedProgram& program, const ComparedRun& run);
Json run_end_json(const LoadedProgram& program, const ComparedRun& run);
/// Indented, with a newline at the end; text with bytes that are no UTF-8 is shown with replacement
/// characters.
std::string text_of(const Json& json);

}  // namespace feedscope
