#pragma once

#include <string_view>

#include "core/program/text/source_text.h"

namespace feedscope::iso {

/// Whether a text of plain words is for a printer or plotter (Marlin and its kin) and not for grbl: it has an
/// M word that only those know, a command of Klipper, or extrudes (E).
bool is_for_printer(const SourceText& text);

/// The command with a name of its own that a line begins with, as Klipper and its macros have them
/// ("SET_VELOCITY_LIMIT ACCEL=1000"); empty: none. Source: Klipper, "G-Codes" (klipper3d.org).
std::string_view klipper_command(std::string_view line);

}  // namespace feedscope::iso
