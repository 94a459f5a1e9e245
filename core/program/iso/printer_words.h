#pragma once

#include "core/program/text/source_text.h"

namespace feedscope::iso {

/// Whether a text of plain words is for a printer or plotter (Marlin and its kin) and not for grbl: it has an
/// M word that only those know, or extrudes (E).
bool is_for_printer(const SourceText& text);

}  // namespace feedscope::iso
