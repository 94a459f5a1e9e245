#pragma once

#include <QString>

#include "core/analysis/run/run.h"

namespace feedscope::ui {

/// Numbers of errors and warnings in reading a program, for all its pictures: "Program read with 2 errors and
/// 1 warning". Empty without any; notes do not count.
QString reading_faults_text(const Program& program);

}  // namespace feedscope::ui
