#pragma once

#include <string_view>

#include "core/program/text/source_text.h"

namespace feedscope::iso {

/// True if a text of plain words is for a printer or plotter (Marlin and similar) and not for grbl: it has an
/// M word that only those know, a command of Klipper, or extrudes (E).
bool is_for_printer(const SourceText& text);

/// Named command at the start of a line, as in Klipper and its macros ("SET_VELOCITY_LIMIT ACCEL=1000");
/// empty: none. Source: Klipper, "G-Codes" (klipper3d.org).
std::string_view klipper_command(std::string_view line);

}  // namespace feedscope::iso
