#include "ui/workbench/setup_state.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope::ui {

namespace {

bool is_axis_key(const std::string& key) {
  return key.size() > 2 && key[1] == '.';
}

}  // namespace

SetupState SetupState::between(Setup file, const Setup& asked) {
  SetupState state(std::move(file));
  const std::string axes = axis_names(asked.machine);
  for (const std::string& key : assignable_keys(*asked.model)) {
    if (is_axis_key(key) && axes.find(key[0]) == std::string::npos) {
      continue;
    }
    state.set(
        key, is_axis_key(key) ? axis_value(asked.machine, key[0], key.substr(2)) : asked.settings.value(key));
  }
  return state;
}

Setup SetupState::setup() const {
  Setup setup = file_;
  for (const auto& [key, value] : edits_) {
    if (is_axis_key(key)) {
      set_axis_value(setup.machine, key[0], key.substr(2), value);
    } else {
      setup.settings.set(key, value);
    }
  }
  return setup;
}

Machine SetupState::machine() const {
  Machine machine = setup().machine;
  machine.model = file_.model->info().id;
  for (const auto& [key, value] : edits_) {
    if (!is_axis_key(key)) {
      machine.settings.set(key, value);
      machine.provenance.insert_or_assign(key, Provenance{"set by hand", false});
    }
  }
  return machine;
}

void SetupState::set_tolerance(double tolerance) {
  for (const auto& [key, value] : settings_for_tolerance(tolerance)) {
    set(key, value);
  }
}

SettingSpec SetupState::spec(const std::string& key) const {
  const bool axis = is_axis_key(key);
  const std::string name = axis ? key.substr(2) : key;
  const std::vector<SettingSpec>& specs = axis ? axis_specs_of(key[0]) : settings_of(*file_.model);
  const auto found = std::ranges::find(specs, name, &SettingSpec::key);
  if (found == specs.end()) {
    throw InputError("unknown key '" + key + "'");
  }
  SettingSpec spec = *found;
  spec.key = key;
  return spec;
}

SettingValue SetupState::value(const std::string& key) const {
  const auto edit = edits_.find(key);
  return edit == edits_.end() ? file_value(key) : edit->second;
}

SettingValue SetupState::file_value(const std::string& key) const {
  if (is_axis_key(key)) {
    return axis_value(file_.machine, key[0], key.substr(2));
  }
  return file_.settings.value(key);
}

Provenance SetupState::provenance(const std::string& key) const {
  const auto found = file_.machine.provenance.find(key);
  return found == file_.machine.provenance.end() ? Provenance{} : found->second;
}

void SetupState::set(const std::string& key, const SettingValue& value) {
  check_setting(spec(key), value, file_.machine.name);
  if (value == file_value(key)) {
    edits_.erase(key);
  } else {
    edits_[key] = value;
  }
}

void SetupState::set_model(const ControlModel& model) {
  file_.model = &model;
  file_.settings = complete_settings(model, file_.machine);
  const std::vector<SettingSpec>& specs = settings_of(model);
  std::erase_if(edits_, [&](const auto& edit) {
    return !is_axis_key(edit.first) && std::ranges::find(specs, edit.first, &SettingSpec::key) == specs.end();
  });
}

std::string axis_key(char axis, const std::string& limit) {
  return std::string(1, axis) + '.' + limit;
}

}  // namespace feedscope::ui
