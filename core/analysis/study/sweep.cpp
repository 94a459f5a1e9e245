#include "core/analysis/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "core/base/typed_number.h"
#include "core/machine/contour_tolerance.h"

namespace feedscope {
namespace {

constexpr const char* tolerance_key = "tolerance";
constexpr std::string_view separators = " \t;";

[[noreturn]] void refuse(const std::string& text, const Message& reason) {
  throw InputError(message(NC_("core",
                               "sweep '{}': {}; write KEY=FROM:TO:logN, KEY=FROM:TO:linN or \"KEY=A;B;C\", "
                               "such as tolerance=0.005:0.1:log12"),
                           text, reason));
}

double number_in(const std::string& text, std::string_view word) {
  const TypedNumber number = typed_list_number(word);
  if (!number.value) {
    refuse(text, number.problem.empty()
                     ? message(NC_("core", "'{}' is not a number, and only numbers can be swept"), word)
                     : message(NC_("core", "'{}' has a comma: {}"), word, number.problem));
  }
  return *number.value;
}

std::vector<std::string_view> split(std::string_view text, std::string_view at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Values between blanks and semicolons; several separators count as one.
std::vector<std::string_view> words_of(std::string_view values) {
  std::vector<std::string_view> words = split(values, separators);
  std::erase_if(words, [](std::string_view word) { return word.empty(); });
  return words;
}

double rounded(double value) {
  constexpr int digits = 5;
  return *typed_number(fmt::format("{:.{}g}", value, digits)).value;
}

Sweep range(const std::string& text, const std::string& key, const std::vector<std::string_view>& parts) {
  if (parts.size() != 3) {
    refuse(text, message(NC_("core", "a range has three parts, not {}"), parts.size()));
  }
  const std::string_view steps = parts[2];
  const bool logarithmic = steps.starts_with("log");
  if (!logarithmic && !steps.starts_with("lin")) {
    refuse(text, message(NC_("core", "'{}' is neither logN nor linN"), steps));
  }
  const double count = number_in(text, steps.substr(3));
  if (!(count >= 2 && count <= static_cast<double>(max_sweep_values) && count == std::floor(count))) {
    refuse(text, message(NC_("core", "{} values; there must be a whole number from 2 to {}"), steps.substr(3),
                         max_sweep_values));
  }
  const double from = number_in(text, parts[0]);
  const double to = number_in(text, parts[1]);
  return make_sweep(key, from, to, static_cast<std::size_t>(count), logarithmic);
}

}  // namespace

Sweep make_sweep(const std::string& key, double from, double to, std::size_t count, bool logarithmic) {
  const std::string text = fmt::format("{}={}:{}:{}{}", key, from, to, logarithmic ? "log" : "lin", count);
  if (!(std::isfinite(from) && std::isfinite(to)) || from == to) {
    refuse(text, message(NC_("core", "from {} to {} is not a range"), from, to));
  }
  if (logarithmic && !(from > 0 && to > 0)) {
    refuse(text, message(NC_("core", "equal ratios need ends above 0, not {}"), std::min(from, to)));
  }
  if (count < 2 || count > max_sweep_values) {
    refuse(text, message(NC_("core", "{} values; there must be 2 to {}"), count, max_sweep_values));
  }
  Sweep sweep{key, {from}, logarithmic};
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double value =
        rounded(logarithmic ? from * std::pow(to / from, share) : from + (to - from) * share);
    if (value != sweep.values.back()) {
      sweep.values.push_back(value);
    }
  }
  if (sweep.values.back() != to) {
    sweep.values.push_back(to);
  }
  return sweep;
}

Sweep parse_sweep(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    refuse(text, NC_("core", "KEY= is missing"));
  }
  const std::string key = text.substr(0, equals);
  const std::string_view values = std::string_view(text).substr(equals + 1);
  if (values.find(':') != std::string_view::npos) {
    return range(text, key, split(values, ":"));
  }
  Sweep sweep{key, {}, false};
  for (const std::string_view word : words_of(values)) {
    const double value = number_in(text, word);
    if (std::ranges::find(sweep.values, value) != sweep.values.end()) {
      refuse(text, message(NC_("core", "{} is listed twice"), value));
    }
    sweep.values.push_back(value);
  }
  if (sweep.values.empty()) {
    refuse(text, NC_("core", "the value is missing"));
  }
  if (sweep.values.size() > max_sweep_values) {
    refuse(text,
           message(NC_("core", "{} values; at most {} are possible"), sweep.values.size(), max_sweep_values));
  }
  return sweep;
}

std::vector<std::string> sweep_keys(const ControlModel& model) {
  std::vector<std::string> keys = assignable_keys(model);
  const bool reads_tolerance = std::ranges::find(keys, contour_tolerance_key) != keys.end();
  if (reads_tolerance) {
    keys.insert(keys.begin(), tolerance_key);
  }
  return keys;
}

SettingSpec sweep_spec(const std::string& key) {
  std::vector<SettingSpec> specs = common_settings();
  std::ranges::copy(all_model_settings(), std::back_inserter(specs));
  for (const char axis : possible_axes) {
    for (SettingSpec spec : axis_specs_of(axis)) {
      spec.key = fmt::format("{}.{}", axis, spec.key);
      specs.push_back(std::move(spec));
    }
  }
  const auto spec =
      std::ranges::find(specs, key == tolerance_key ? contour_tolerance_key : key, &SettingSpec::key);
  if (spec != specs.end()) {
    return *spec;
  }
  SettingSpec unknown;
  unknown.key = unknown.title = key;
  return unknown;
}

std::string sweep_unit(const std::string& key) {
  return sweep_spec(key).unit;
}

void apply_swept(const std::string& key, double value, Setup& setup) {
  if (key == tolerance_key) {
    set_tolerance(setup, value);
  } else {
    apply_setting(fmt::format("{}={}", key, value), *setup.model, setup.machine, setup.settings);
  }
}

}  // namespace feedscope
