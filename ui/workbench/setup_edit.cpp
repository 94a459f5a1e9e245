#include "ui/workbench/setup_edit.h"

#include "core/base/error.h"

namespace feedscope::ui {

SetupEdit::SetupEdit(RunList& runs, QObject* parent) : QObject(parent), runs_(runs) {
  connect(&runs_, &RunList::setup_changed, this, &SetupEdit::follow);
  connect(&runs_, &RunList::current_changed, this, &SetupEdit::keys_changed);
}

void SetupEdit::follow(std::size_t row, const SetupState& before) {
  if (row != runs_.current()) {
    return;
  }
  if (before.file() == file()) {
    emit values_changed();
  } else {
    emit keys_changed();
  }
}

std::optional<double> SetupEdit::interpolation_period() const {
  constexpr const char* key = "interpolation_period_s";
  return file().settings.has(key) ? std::optional(std::get<double>(state().value(key))) : std::nullopt;
}

void SetupEdit::set_file(Setup file) {
  const QString name = QString::fromStdString(file.machine.name);
  put(SetupState(std::move(file)), tr("machine %1").arg(name));
}

void SetupEdit::set_model(const ControlModel& model) {
  SetupState changed = state();
  changed.set_model(model);
  put(changed, tr("model %1").arg(QString::fromStdString(model.info().id)));
}

void SetupEdit::set(const std::string& key, const SettingValue& value) {
  change([&](SetupState& setup) { setup.set(key, value); }, QString::fromStdString(key));
}

void SetupEdit::set_tolerance(double tolerance) {
  change([&](SetupState& setup) { setup.set_tolerance(tolerance); }, tr("contour tolerance"));
}

void SetupEdit::change(const std::function<void(SetupState&)>& change, const QString& text) {
  SetupState changed = state();
  change(changed);
  if (!for_all_) {
    put(changed, text);
    return;
  }
  std::vector<SetupState> setups;
  for (const RunItem& run : runs_.items()) {
    setups.push_back(run.setup);
    try {
      change(setups.back());
    } catch (const InputError&) {
      setups.back() = run.setup;
    }
  }
  runs_.set_setups(setups, tr("%1 in all runs").arg(text));
}

void SetupEdit::reset() {
  SetupState changed = state();
  changed.reset();
  put(changed, tr("back to the machine file"));
}

void SetupEdit::put(const SetupState& state, const QString& text) {
  runs_.set_setup(runs_.current(), state, text);
}

}  // namespace feedscope::ui
