#pragma once

#include <functional>

namespace feedscope::ui {

/// The row with the next time after (or before) `time` [s]; beyond the last one, the first. -1 without rows.
int next_place(int rows, const std::function<double(int)>& time_of, double time, bool forward);

}  // namespace feedscope::ui
