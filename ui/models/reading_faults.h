#pragma once

#include <QString>

#include "core/program/program.h"

namespace feedscope::ui {

/// How many errors and warnings the reading of a program has, for every picture of it: "Program read with 2
/// errors and 1 warning". Empty where there is none; notes do not count.
QString reading_faults_text(const Program& program);

}  // namespace feedscope::ui
