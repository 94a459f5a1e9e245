#include "ui/trace/trace_presets.h"

#include <QSettings>
#include <algorithm>

#include "core/trace/trace_columns.h"

namespace feedscope::ui {

namespace {

const QString settings_group = QStringLiteral("trace_presets");

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

std::vector<KeptTracePreset> kept_trace_presets() {
  std::vector<KeptTracePreset> presets;
  for (const TracePreset& preset : trace_presets()) {
    presets.push_back({text_of(preset.name), text_of(preset.specification), false});
  }
  QSettings settings;
  settings.beginGroup(settings_group);
  for (const QString& name : settings.childKeys()) {
    presets.push_back({name, settings.value(name).toString(), true});
  }
  return presets;
}

bool keep_trace_preset(const QString& name, const QString& specification) {
  const QString kept = name.trimmed().replace('/', '-').replace('\\', '-');  // slashes form groups
  if (kept.isEmpty() || std::ranges::any_of(trace_presets(), [&](const TracePreset& preset) {
        return text_of(preset.name) == kept;
      })) {
    return false;
  }
  QSettings().setValue(settings_group + '/' + kept, specification);
  return true;
}

void forget_trace_preset(const QString& name) {
  QSettings().remove(settings_group + '/' + name);
}

}  // namespace feedscope::ui
