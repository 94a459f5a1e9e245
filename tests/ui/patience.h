#pragma once

namespace feedscope::ui {

/// How long a test waits for work of another thread before it fails [ms].
inline constexpr int patience = 120000;

}  // namespace feedscope::ui
