#include "ui/models/setup_edit.h"

#include <QUndoCommand>
#include <algorithm>

#include "core/base/error.h"

namespace feedscope::ui {

namespace {

bool is_axis_key(const std::string& key) {
  return key.size() > 2 && key[1] == '.';
}

SettingValue value_in(const Setup& setup, const std::string& key) {
  if (is_axis_key(key)) {
    return axis_limit(setup.machine, key[0], key.substr(2));
  }
  return setup.settings.values().at(key);
}

}  // namespace

class SetupEdit::Edit : public QUndoCommand {
 public:
  Edit(SetupEdit& setup, std::string key, SettingValue value)
      : setup_(setup), key_(std::move(key)), before_(setup.value(key_)), after_(std::move(value)) {
    setText(QString::fromStdString(key_));
  }
  void undo() override { setup_.put(key_, before_); }
  void redo() override { setup_.put(key_, after_); }

 private:
  SetupEdit& setup_;
  std::string key_;
  SettingValue before_;
  SettingValue after_;
};

SetupEdit::SetupEdit(Setup file, QObject* parent) : QObject(parent), file_(std::move(file)) {}

void SetupEdit::set_file(Setup file) {
  file_ = std::move(file);
  edits_.clear();
  history_.clear();
  emit keys_changed();
}

void SetupEdit::set_model(const ControlModel& model) {
  file_.model = &model;
  file_.settings = complete_settings(model, file_.machine);
  std::erase_if(edits_, [this](const auto& edit) {
    return !is_axis_key(edit.first) && !file_.settings.has(edit.first);
  });
  history_.clear();
  emit keys_changed();
}

Setup SetupEdit::setup() const {
  Setup setup = file_;
  for (const auto& [key, value] : edits_) {
    if (is_axis_key(key)) {
      set_axis_limit(setup.machine, key[0], key.substr(2), std::get<double>(value));
    } else {
      setup.settings.set(key, value);
    }
  }
  return setup;
}

SettingSpec SetupEdit::spec(const std::string& key) const {
  const bool axis = is_axis_key(key);
  const std::string name = axis ? key.substr(2) : key;
  const std::vector<SettingSpec> specs = axis ? axis_limit_specs() : settings_of(*file_.model);
  const auto found = std::ranges::find(specs, name, &SettingSpec::key);
  if (found == specs.end()) {
    throw InputError("unknown key '" + key + "'");
  }
  SettingSpec spec = *found;
  spec.key = key;
  return spec;
}

SettingValue SetupEdit::value(const std::string& key) const {
  const auto edit = edits_.find(key);
  return edit == edits_.end() ? file_value(key) : edit->second;
}

SettingValue SetupEdit::file_value(const std::string& key) const {
  return value_in(file_, key);
}

Provenance SetupEdit::provenance(const std::string& key) const {
  const auto found = file_.machine.provenance.find(key);
  return found == file_.machine.provenance.end() ? Provenance{} : found->second;
}

void SetupEdit::set(const std::string& key, const SettingValue& value) {
  check_setting(spec(key), value, file_.machine.name);
  if (value != this->value(key)) {
    history_.push(new Edit(*this, key, value));
  }
}

void SetupEdit::put(const std::string& key, const SettingValue& value) {
  if (value == file_value(key)) {
    edits_.erase(key);
  } else {
    edits_[key] = value;
  }
  emit values_changed();
}

std::string axis_key(char axis, const std::string& limit) {
  return std::string(1, axis) + '.' + limit;
}

}  // namespace feedscope::ui
