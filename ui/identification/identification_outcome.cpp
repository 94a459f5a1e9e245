#include "ui/identification/identification_outcome.h"

#include <QCryptographicHash>
#include <algorithm>
#include <numeric>

namespace feedscope::ui {
namespace {

bool begins_with(const Identification& found, const IdentificationStart& start) {
  return found.setup.model == start.setup.model && found.parameters.size() == start.keys.size() &&
         std::equal(found.parameters.begin(), found.parameters.end(), start.keys.begin(),
                    [&](const IdentifiedParameter& one, const std::string& key) {
                      return one.parameter.key == key && one.start == fit_value(start.setup, one.parameter);
                    });
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
