#pragma once

#include <span>

namespace feedscope::ui {

/// Patterns of the messages and hints on programs and of what stands in their places, as core writes them
/// with fmt::format(), %1 and on for the parts. Of all dialects and of rotary axes:
std::span<const char* const> general_sentences();
/// Of each family of dialects (core/program/iso, sinumerik, heidenhain); what an earlier one has, in this
/// order, is not repeated.
std::span<const char* const> iso_sentences();
std::span<const char* const> sinumerik_sentences();
std::span<const char* const> heidenhain_sentences();
/// Why a simulated control rejects a line (core/models/grbl, klipper).
std::span<const char* const> control_sentences();
/// Of the notes on an imported configuration of a control (core/machine/import).
std::span<const char* const> import_sentences();
/// Of what is thrown as InputError: what is wrong with a file or with what was asked for.
std::span<const char* const> failure_sentences();

}  // namespace feedscope::ui
