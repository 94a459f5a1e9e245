#pragma once

#include <span>

namespace feedscope::ui {

/// Patterns of the readers' messages and hints and of the parts in their places, as core's fmt::format()
/// texts with %1 and on. For all dialects and rotary axes:
std::span<const char* const> general_sentences();
/// For each family of dialects (core/program/iso, sinumerik, heidenhain); patterns of earlier ones, in this
/// order, are not repeated.
std::span<const char* const> iso_sentences();
std::span<const char* const> sinumerik_sentences();
std::span<const char* const> heidenhain_sentences();
/// Reasons why a simulated control rejects a line (core/models/grbl, klipper).
std::span<const char* const> control_sentences();
/// Notes on an imported configuration of a control (core/machine/import).
std::span<const char* const> import_sentences();
/// Texts of InputError: errors in a file or a request.
std::span<const char* const> failure_sentences();

}  // namespace feedscope::ui
