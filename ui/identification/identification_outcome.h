#pragma once

#include <QByteArray>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/identification/recordings.h"
#include "core/identification/unfitted_model.h"

namespace feedscope::ui {

/// An opened table of section times.
struct SectionTable {
  QString name;  ///< of its file
  std::vector<SectionTime> times;
};

/// A model with its initial machine, and the numbers to identify.
struct IdentificationStart {
  Setup setup;
  std::vector<std::string> keys;

  bool operator==(const IdentificationStart&) const = default;
};

/// The recordings to explain, and the models to try.
struct IdentificationRequest {
  LoadedProgram program;
  std::vector<std::shared_ptr<const Trace>> traces;
  std::vector<std::shared_ptr<const SectionTable>> tables;
  std::vector<IdentificationStart> starts;

  /// Two readings of a file are different recordings.
  bool operator==(const IdentificationRequest& other) const {
    return program.program == other.program.program && traces == other.traces && tables == other.tables &&
           starts == other.starts;
  }
};

/// A recording used for a result: its name, and what distinguishes it from others of this name.
struct UsedRecording {
  QString name;  ///< of the file, without its folder
  bool is_table = false;
  std::size_t size = 0;  ///< samples or sections
  double seconds = 0;    ///< from the first to the last sample, or of all sections [s]
  double sum = 0;        ///< of all coordinates [mm] or times [s]

  bool operator==(const UsedRecording&) const = default;
};

/// Results of an identification. One restored from a session has no Identification::runs; its agreements have
/// only times, feeds, distances and the times of cells, and each FitParameter only key and unit.
struct IdentificationOutcome {
  std::string date;    ///< "2026-11-27"
  QByteArray program;  ///< program_mark() of the recorded program
  std::vector<UsedRecording> recordings;
  std::vector<Identification> models;  ///< the best explanation first; at least one
  std::vector<UnfittedModel> unfitted;
};

/// SHA-256 of the program's text, in hex.
QByteArray program_mark(const LoadedProgram& program);

UsedRecording used_recording(const Trace& trace);
UsedRecording used_recording(const SectionTable& table);
/// The recordings of a request, in the order of the agreements.
std::vector<UsedRecording> used_recordings(const IdentificationRequest& request);

/// Whether `outcome` answers `request`: the same program, recordings, models, numbers and initial machines.
/// The search is then not repeated.
bool is_of(const IdentificationOutcome& outcome, const IdentificationRequest& request);

}  // namespace feedscope::ui
