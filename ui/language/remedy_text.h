#pragma once

#include <QString>

#include "core/analysis/explanation/remedies.h"

namespace feedscope::ui {

/// A change of `setup` in the user's language: "Jerk of axis X 5 → 7.5 m/s³", "On Huron KX10"; several parts
/// separated by commas.
QString remedy_text(const Remedy& remedy, const Setup& setup);

}  // namespace feedscope::ui
