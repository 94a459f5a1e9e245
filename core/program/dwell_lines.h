#pragma once

#include <string>
#include <vector>

#include "core/program/dialect.h"

namespace feedscope {

/// Lines of a program that make the axes wait for `time` [s].
std::vector<std::string> dwell_lines(Dialect dialect, double time);

}  // namespace feedscope
