#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/watch.h"
#include "core/identification/recordings.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// A recording used for identification, as a report shows it.
struct ReportedRecording {
  std::string file;
  std::shared_ptr<const Trace> trace;  ///< null: a table
  std::vector<SectionTime> times;      ///< of a table
  bool of_first_program = true;        ///< whether the report shows its program
};

/// Input of an identification report.
struct IdentificationReport {
  std::vector<Identification> models;  ///< the best explanation first
  std::vector<UnfittedModel> unfitted;
  std::vector<ReportedRecording> recordings;
  std::string machine_file;  ///< name of the written file; "" for none
  std::string command;       ///< that repeats the identification
  std::string language;
};

/// Throws InputError for a file name that ends neither in .pdf nor in .html.
void check_report_name(const std::string& file);

/// The bytes of the report `file`: the first program on the machine that the first model found, compared with
/// its traces. Throws Cancelled.
std::string identification_report(const IdentificationReport& made, const std::string& file, Watch& watch);

}  // namespace feedscope
