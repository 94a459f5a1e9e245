#pragma once

#include <QByteArray>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/identification/recordings.h"
#include "core/identification/unfitted_model.h"

namespace feedscope::ui {

/// A table of section times that was opened.
struct SectionTable {
  QString name;  ///< of its file
  std::vector<SectionTime> times;
};

/// A model with the machine that is begun with, and what of them is to be found.
struct IdentificationStart {
  Setup setup;
  std::vector<std::string> keys;

  bool operator==(const IdentificationStart&) const = default;
};

/// What is to be explained, by which models.
struct IdentificationRequest {
  LoadedProgram program;
  std::vector<std::shared_ptr<const Trace>> traces;
  std::vector<std::shared_ptr<const SectionTable>> tables;
  std::vector<IdentificationStart> starts;

  /// Another reading of a file is another recording.
  bool operator==(const IdentificationRequest& other) const {
    return program.program == other.program.program && traces == other.traces && tables == other.tables &&
           starts == other.starts;
  }
};

/// A recording that something was found from: its name, and what tells it from another of this name.
struct UsedRecording {
  QString name;  ///< of the file, without its folder
  bool is_table = false;
  std::size_t size = 0;  ///< samples or sections
  double seconds = 0;    ///< from the first to the last sample, or of all sections [s]
  double sum = 0;        ///< of all coordinates [mm] or times [s]

  bool operator==(const UsedRecording&) const = default;
};

/// What was identified. One that a session kept has no Identification::runs, of the agreements only times,
/// feeds, distances and the times of cells, and of each FitParameter only key and unit.
struct IdentificationOutcome {
  std::string date;    ///< "2026-11-27"
  QByteArray program;  ///< program_mark() of the one that was recorded
  std::vector<UsedRecording> recordings;
  std::vector<Identification> models;  ///< the one that explains best first; at least one
  std::vector<UnfittedModel> unfitted;
};

/// SHA-256 of the program's text, in hex.
QByteArray program_mark(const LoadedProgram& program);

UsedRecording used_recording(const Trace& trace);
UsedRecording used_recording(const SectionTable& table);
/// Those of a request, in the order in which agreements stand.
std::vector<UsedRecording> used_recordings(const IdentificationRequest& request);

/// Whether `outcome` was found from what `request` asks for: the same program, recordings, models, numbers
/// and what they are begun with. The search is not done again for that.
bool is_of(const IdentificationOutcome& outcome, const IdentificationRequest& request);

}  // namespace feedscope::ui
