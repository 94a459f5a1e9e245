#pragma once

#include <QString>
#include <vector>

namespace feedscope::ui {

/// How tables of samples are read, under a name: those that come with the program, and the user's own, which
/// are kept in the settings.
struct KeptTracePreset {
  QString name;
  QString specification;  ///< as parse_trace_columns() reads it
  bool own = false;       ///< the user's
};

/// Those of the program first.
std::vector<KeptTracePreset> kept_trace_presets();
/// Another one, or in place of the user's own of that name. False, and nothing happens, for an empty name and
/// for one of the program.
bool keep_trace_preset(const QString& name, const QString& specification);
/// Of the user.
void forget_trace_preset(const QString& name);

}  // namespace feedscope::ui
