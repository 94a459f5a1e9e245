#include "ui/workbench/setup_edit.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/machine/contour_tolerance.h"

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

bool SetupEdit::is_common(const std::function<bool(const SetupState&)>& same_part) const {
  for (std::size_t row = 0; row < runs_.items().size(); ++row) {
    const SetupState& other = runs_.items()[row].setup;
    if (row != runs_.current() && (other == state() || !same_part(other))) {
      return false;
    }
  }
  return true;
}

/// Of a limit of an axis, that of all axes: runs with another jerk of X are compared in their jerk.
bool SetupEdit::same_in_all(const std::string& key) const {
  std::vector<std::string> keys{key};
  if (const std::size_t point = key.find('.'); point != std::string::npos) {
    for (const char axis : axis_names(file().machine)) {
      keys.push_back(axis_key(axis, key.substr(point + 1)));
    }
  }
  return is_common([&](const SetupState& other) {
    return std::ranges::all_of(keys, [&](const std::string& each) {
      try {
        other.spec(each);
        return other.value(each) == state().value(each);
      } catch (const InputError&) {
        return true;  // its machine or model has no such value
      }
    });
  });
}

void SetupEdit::set_file(const Setup& file) {
  std::set<std::string> compared;
  for (const RunItem& run : runs_.items()) {
    for (const auto& [key, value] : run.setup.edits()) {
      if (!same_in_all(key)) {
        compared.insert(key);
      }
    }
  }
  const auto same_model = [this](const SetupState& other) {
    return other.file().model == this->file().model;
  };
  const bool models_differ = !is_common(same_model);
  const auto move = [&](SetupState& setup) {
    SetupState moved(file);
    if (models_differ && runs_.items().size() > 1) {
      moved.set_model(*setup.file().model);
    }
    for (const std::string& key : compared) {
      try {
        moved.set(key, setup.value(key));
      } catch (const InputError&) {  // this machine or model does not take it
      }
    }
    setup = moved;
  };
  const bool in_all =
      is_common([this](const SetupState& other) { return other.file().machine == this->file().machine; });
  change(move, tr("machine %1").arg(QString::fromStdString(file.machine.name)), in_all);
}

void SetupEdit::set_model(const ControlModel& model) {
  const bool in_all =
      is_common([this](const SetupState& other) { return other.file().model == file().model; });
  change([&](SetupState& setup) { setup.set_model(model); },
         tr("model %1").arg(QString::fromStdString(model.info().id)), in_all);
}

void SetupEdit::set(const std::string& key, const SettingValue& value) {
  change([&](SetupState& setup) { setup.set(key, value); }, QString::fromStdString(key), same_in_all(key));
}

void SetupEdit::set_tolerance(double tolerance) {
  bool in_all = true;
  for (const auto& [key, value] : settings_for_tolerance(tolerance)) {
    in_all = in_all && same_in_all(key);
  }
  change([&](SetupState& setup) { setup.set_tolerance(tolerance); }, tr("contour tolerance"), in_all);
}

void SetupEdit::change(const std::function<void(SetupState&)>& change, const QString& text, bool in_all) {
  SetupState changed = state();
  change(changed);
  if (!for_all_ || !in_all || runs_.items().size() < 2) {
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
