#include "ui/identification/identification_outcome.h"

#include <QCryptographicHash>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace feedscope::ui {
namespace {

/// Equality; of numbers up to the rounding of a file.
bool is_same(const SettingValue& a, const SettingValue& b) {
  constexpr double rounding = 1e-9;
  const auto* number = std::get_if<double>(&a);
  const auto* other = std::get_if<double>(&b);
  return number == nullptr || other == nullptr
             ? a == b
             : std::abs(*number - *other) <= rounding * std::max(std::abs(*number), std::abs(*other));
}

/// Whether both have the same axes, limits and settings except `fitted`, regardless of sources. Both have the
/// same model.
bool is_same_but_for(const std::vector<std::string>& fitted, const Setup& a, const Setup& b) {
  const std::string axes = axis_names(a.machine);
  const std::vector<std::string> keys = assignable_keys(*a.model);
  return axes == axis_names(b.machine) && std::ranges::all_of(keys, [&](const std::string& key) {
           if (std::ranges::find(fitted, key) != fitted.end()) {
             return true;
           }
           if (key.size() < 3 || key[1] != '.') {
             return is_same(a.settings.value(key), b.settings.value(key));
           }
           const std::string limit = key.substr(2);
           return axes.find(key[0]) == std::string::npos ||
                  is_same(axis_value(a.machine, key[0], limit), axis_value(b.machine, key[0], limit));
         });
}

bool begins_with(const Identification& found, const IdentificationStart& start) {
  // Numbers found in addition, of a drive or a feed override, were not requested.
  std::vector<std::string> found_keys = start.keys;
  for (const IdentifiedParameter& one : found.parameters) {
    found_keys.push_back(one.parameter.key);
  }
  return found.setup.model == start.setup.model &&
         std::ranges::all_of(
             start.keys,
             [&](const std::string& key) {
               return std::ranges::any_of(found.parameters, [&](const IdentifiedParameter& one) {
                 return one.parameter.key == key && one.start == fit_value(start.setup, one.parameter);
               });
             }) &&
         is_same_but_for(found_keys, found.setup, start.setup);
}

}  // namespace

QByteArray program_mark(const LoadedProgram& program) {
  const std::string& text = program.program->source->text();
  return QCryptographicHash::hash(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())),
                                  QCryptographicHash::Sha256)
      .toHex();
}

UsedRecording used_recording(const Trace& trace) {
  UsedRecording recording{QString::fromStdString(trace.name).section('/', -1), false, trace.size(),
                          trace.duration()};
  for (const std::vector<double>& axis : trace.place) {
    recording.sum = std::accumulate(axis.begin(), axis.end(), recording.sum);
  }
  return recording;
}

UsedRecording used_recording(const SectionTable& table) {
  UsedRecording recording{table.name.section('/', -1), true, table.times.size()};
  for (const SectionTime& time : table.times) {
    recording.seconds += time.seconds;
  }
  recording.sum = recording.seconds;
  return recording;
}

std::vector<UsedRecording> used_recordings(const IdentificationRequest& request) {
  std::vector<UsedRecording> recordings;
  for (const auto& trace : request.traces) {
    recordings.push_back(used_recording(*trace));
  }
  for (const auto& table : request.tables) {
    recordings.push_back(used_recording(*table));
  }
  return recordings;
}

bool is_of(const IdentificationOutcome& outcome, const IdentificationRequest& request) {
  const auto is_begun = [&](const Identification& found) {
    return std::ranges::any_of(request.starts,
                               [&](const IdentificationStart& start) { return begins_with(found, start); });
  };
  return request.program.program != nullptr && outcome.program == program_mark(request.program) &&
         outcome.models.size() + outcome.unfitted.size() == request.starts.size() &&
         std::ranges::all_of(outcome.models, is_begun) && outcome.recordings == used_recordings(request);
}

}  // namespace feedscope::ui
