#pragma once

#include <QString>
#include <vector>

namespace feedscope::ui {

/// A named way to read tables of samples: shipped, or the user's own, stored in the settings.
struct KeptTracePreset {
  QString name;
  QString specification;  ///< for parse_trace_columns()
  bool own = false;       ///< whether it is the user's
};

/// Shipped presets first.
std::vector<KeptTracePreset> kept_trace_presets();
/// Adds a preset, or replaces the user's own one of that name. Returns false without effect for an empty name
/// and for a shipped preset.
bool keep_trace_preset(const QString& name, const QString& specification);
/// Deletes a preset of the user.
void forget_trace_preset(const QString& name);

}  // namespace feedscope::ui
