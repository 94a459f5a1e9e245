#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/watch.h"
#include "core/identification/recordings.h"
#include "core/identification/unfitted_model.h"

namespace feedscope {

/// A recording that something was identified from, as a report shows it.
struct ReportedRecording {
  std::string file;
  std::shared_ptr<const Trace> trace;  ///< null: a table
  std::vector<SectionTime> times;      ///< of a table
  bool of_first_program = true;        ///< the report is of that one
};

/// What a report of an identification is made of.
struct IdentificationReport {
  std::vector<Identification> models;  ///< the one that explains best first
  std::vector<UnfittedModel> unfitted;
  std::vector<ReportedRecording> recordings;
  std::string machine_file;  ///< that was written; "" for none
  std::string command;       ///< that makes it again
  std::string language;
};

/// Throws InputError for a file name that ends neither in .pdf nor in .html.
void check_report_name(const std::string& file);

/// The bytes of the report `file` of the first program on the machine that the first model found, beside its
/// traces. Throws Cancelled.
std::string identification_report(const IdentificationReport& made, const std::string& file, Watch& watch);

}  // namespace feedscope
