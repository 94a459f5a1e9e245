#pragma once

#include <memory>

#include "core/program/program.h"

namespace feedscope {

/// Reads a program as Klipper does (README.md, "Reading"): every line must begin with its command, unknown
/// ones and those with errors have no effect and are notes of code "refused". Rapids run at the feed in
/// force.
Program read_as_klipper(std::shared_ptr<const SourceText> source);

}  // namespace feedscope
