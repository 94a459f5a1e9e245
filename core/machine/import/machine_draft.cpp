#include "core/machine/import/machine_draft.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/typed_number.h"

namespace feedscope {
namespace {

std::string axis_key(char axis, std::string_view key) {
  return fmt::format("{}.{}", axis, key);
}

}  // namespace

MachineDraft::MachineDraft(std::string file, const std::vector<SettingSpec>& model_settings)
    : file_(std::move(file)), specs_(common_settings()) {
  specs_.insert(specs_.end(), model_settings.begin(), model_settings.end());
}

const SettingSpec* MachineDraft::find_setting(std::string_view key) const {
  const auto found = std::ranges::find(specs_, key, &SettingSpec::key);
  return found == specs_.end() ? nullptr : &*found;
}

void MachineDraft::choose_model(const std::vector<std::string>& ids) {
  const SettingSpec* models = find_setting("model");
  const auto known = std::ranges::find_if(ids, [&](const std::string& id) {
    return models == nullptr || std::ranges::find(models->choices, id) != models->choices.end();
  });
  imported_.machine.model = known == ids.end() ? models->choices.front() : *known;
}

bool MachineDraft::is_within(const SettingSpec& spec, const SettingValue& value, const GivenValue& given) {
  try {
    check_setting(spec, value, "");
    return true;
  } catch (const InputError& error) {
    note(Severity::error, given.place, "limit-out-of-bounds",
         message(NC_("core", "{} cannot be used: {}"), given.what, error.message()),
         NC_("core", "correct the file of the control; until then the value is assumed"));
    return false;
  }
}

void MachineDraft::give_axis(char axis, std::string_view key, double value, const GivenValue& given) {
  SettingSpec spec = *std::ranges::find(axis_specs(), key, &SettingSpec::key);
  spec.key = axis_key(axis, key);
  if (is_within(spec, value, given)) {
    set_axis_value(imported_.machine, axis, key, value);
    imported_.machine.provenance[spec.key] = {fmt::format("{}: {}", place_text(given.place), given.what),
                                              false};
  }
}

void MachineDraft::assume_axis(char axis, std::string_view key, double value, const std::string& reason) {
  const SettingSpec& spec = *std::ranges::find(axis_specs(), key, &SettingSpec::key);
  set_axis_value(imported_.machine, axis, key, nearest_within(spec, value));
  imported_.machine.provenance[axis_key(axis, key)] = {reason, true};
}

bool MachineDraft::has_axis(char axis, std::string_view key) const {
  return imported_.machine.provenance.contains(axis_key(axis, key));
}

double MachineDraft::axis(char axis, std::string_view key) const {
  return has_axis(axis, key) ? std::get<double>(axis_value(imported_.machine, axis, key)) : 0;
}

void MachineDraft::give(std::string_view key, const SettingValue& value, const GivenValue& given) {
  const SettingSpec* spec = find_setting(key);
  if (spec != nullptr && is_within(*spec, value, given)) {
    imported_.machine.settings.set(spec->key, value);
    imported_.machine.provenance[spec->key] = {fmt::format("{}: {}", place_text(given.place), given.what),
                                               false};
  }
}

void MachineDraft::assume(std::string_view key, const SettingValue& value, const std::string& reason) {
  const SettingSpec* spec = find_setting(key);
  if (spec != nullptr) {
    const double* number = std::get_if<double>(&value);
    imported_.machine.settings.set(spec->key,
                                   number != nullptr ? SettingValue(nearest_within(*spec, *number)) : value);
    imported_.machine.provenance[spec->key] = {reason, true};
  }
}

std::optional<double> MachineDraft::number(std::string_view text, const GivenValue& given) {
  const TypedNumber number = typed_number(text);
  if (!number.value) {
    note(Severity::error, given.place, "not-a-number",
         number.problem.empty() ? message(NC_("core", "{}: '{}' is not a number"), given.what, text)
                                : at_place(given.what, number.problem),
         NC_("core", "correct the file of the control; until then the value is assumed"));
  }
  return number.value;
}

void MachineDraft::note(Severity severity, const ConfigurationPlace& place, const char* code, Message what,
                        Message hint) {
  Diagnostic note;
  note.severity = severity;
  note.line = place.line;
  note.code = code;
  note.message = std::move(what);
  note.hint = std::move(hint);
  note.file = place.file;
  imported_.notes.push_back(std::move(note));
}

void MachineDraft::leave_out(const std::string& name) {
  if (std::ranges::find(left_out_, name) == left_out_.end()) {
    left_out_.push_back(name);
  }
}

void MachineDraft::list_what_is_left_out() {
  constexpr std::size_t most_names = 100;
  if (left_out_.empty()) {
    return;
  }
  const std::size_t named = std::min(left_out_.size(), most_names);
  const std::string names = fmt::format(
      "{}", fmt::join(left_out_.begin(), left_out_.begin() + static_cast<std::ptrdiff_t>(named), ", "));
  const std::size_t rest = left_out_.size() - named;
  note(Severity::info, {}, "not-used",
       rest == 0 ? message(NC_("core", "not used: {}"), names)
                 : message(NC_("core", "not used: {} and {} more"), names, rest));
}

std::string MachineDraft::place_text(const ConfigurationPlace& place) const {
  return place.line == 0 ? file_
                         : fmt::format("{}, line {}", place.file.empty() ? file_ : place.file, place.line);
}

void MachineDraft::fill(std::string_view key, double usual) {
  const AxisList axes = imported_.machine.axes.axes();
  const auto given =
      std::ranges::find_if(axes, [&](const AxisInfo& axis) { return has_axis(axis.name, key); });
  for (const AxisInfo& axis : axes) {
    if (has_axis(axis.name, key)) {
      continue;
    }
    if (given == axes.end()) {
      assume_axis(axis.name, key, usual, fmt::format("{} does not give it: usual of such machines", file_));
    } else {
      const double other = std::get<double>(axis_value(imported_.machine, given->name, key));
      assume_axis(axis.name, key, other, fmt::format("{} does not give it: as {}", file_, given->name));
    }
  }
}

void MachineDraft::fill_jerk(const UsualLimits& usual) {
  constexpr double least_rise = 0.005;  // [s] to reach an acceleration without a jerk limit
  const std::string none = fmt::format("{} limits no jerk: for other models, so high that it hardly limits",
                                       imported_.machine.control);
  for (const AxisInfo& axis : imported_.machine.axes.axes()) {
    const double acceleration = std::get<double>(axis_value(imported_.machine, axis.name, "acceleration"));
    if (usual.jerk == 0) {
      assume_axis(axis.name, "jerk", acceleration / least_rise, none);
      assume_axis(axis.name, "blend_jerk", acceleration / least_rise, none);
    }
  }
  if (usual.jerk > 0) {
    fill("jerk", usual.jerk);
  }
  for (const AxisInfo& axis : imported_.machine.axes.axes()) {
    if (!has_axis(axis.name, "blend_jerk")) {
      assume_axis(axis.name, "blend_jerk", std::get<double>(axis_value(imported_.machine, axis.name, "jerk")),
                  fmt::format("as the jerk: {} gives none for blends", file_));
    }
  }
}

void MachineDraft::close_notes() {
  constexpr std::size_t most_notes = 200;
  std::vector<Diagnostic>& notes = imported_.notes;
  std::ranges::stable_sort(notes, [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.file, a.line) < std::pair(b.file, b.line);
  });
  if (notes.size() <= most_notes) {
    return;
  }
  const std::vector<Diagnostic> rest(notes.begin() + most_notes, notes.end());
  notes.resize(most_notes);
  note(std::ranges::max(rest, {}, &Diagnostic::severity).severity, {}, "more-notes",
       message(NC_("core", "{} more notes are not listed"), rest.size()),
       NC_("core", "correct what is listed, and import the file once more"));
}

ImportedMachine MachineDraft::finish(std::string kind, const UsualLimits& usual) {
  fill("velocity", usual.velocity);
  fill("acceleration", usual.acceleration);
  fill_jerk(usual);
  imported_.kind = std::move(kind);
  list_what_is_left_out();
  close_notes();
  return std::move(imported_);
}

}  // namespace feedscope
