#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/identification/identify.h"
#include "core/identification/section_times.h"

namespace feedscope {

/// Recordings of a machine, each with its program: traces and tables of section times, to be explained by one
/// control model after the other.
class Recordings {
 public:
  /// Returns the progress for the next stage of the work, with its title for display: "matching", "fitting";
  /// null for none.
  using Stage = std::function<Progress*(const char* title)>;

  void add(std::shared_ptr<const Trace> trace, const LoadedProgram& program);
  void add(std::vector<SectionTime> times, const std::string& name, const LoadedProgram& program);
  std::size_t size() const { return items_.size(); }
  /// Default parameters: usual_fit_parameters(), and the drives of axes with recorded set and actual
  /// positions.
  std::vector<FitParameter> usual_parameters(const Setup& start) const;

  /// Finds the `parameters` of `start` with which its model explains all recordings best; those of drives by
  /// fit_drive(). If the model does not explain them, a tolerance for which zero means no limit is tried at
  /// zero. If all traces run at one share of the programmed feed, it is assumed to be the feed override.
  /// Throws InputError for a recording that does not belong to its program, covers too little of it or has a
  /// wrong rate, for impossible section times (SectionCase::check_times()), for a drive without set and
  /// actual positions, and as identify() does.
  Identification fit(const Setup& start, const std::vector<FitParameter>& parameters,
                     const IdentifyOptions& options = {}, const Stage& stage = {});
  /// Problems of each recording on its program: available after fit(); none for tables.
  const std::vector<std::vector<Diagnostic>>& remarks() const { return remarks_; }

 private:
  struct Item {
    std::shared_ptr<const Trace> trace;  ///< null: section times
    std::vector<SectionTime> times;
    std::string name;  ///< of the table
    LoadedProgram program;
  };

  std::vector<const Trace*> traces() const;
  std::vector<DriveFit> fit_drives(const std::vector<FitParameter>& parameters, Setup& setup,
                                   Progress* progress);
  std::optional<double> feed_share() const;
  Identification fit_as_begun(const Setup& start, const std::vector<FitParameter>& parameters,
                              const IdentifyOptions& options, const Stage& stage);
  const DriveFit& drive_of_axis(char axis, const AxisDrive& start, const FreeDriveNumbers& free,
                                Progress* progress);
  void add_drive(Identification& found, const DriveFit& drive, const std::string& date) const;

  /// An identified drive: independent of the control model.
  struct FoundDrive {
    AxisDrive start;
    FreeDriveNumbers free;
    DriveFit fit;
  };

  std::vector<Item> items_;
  std::deque<FoundDrive> drives_;
  std::vector<std::vector<Diagnostic>> remarks_;
  std::vector<std::optional<double>> feed_shares_;  ///< by recording; none for tables
};

/// Keys of usual_fit_parameters() that were fixed: if a model does not explain the recordings, they may be
/// the cause.
std::vector<std::string> held_parameters(const Identification& found);

/// Whether a file is a table of section times; false if it cannot be read.
bool is_section_times_file(const std::filesystem::path& file);
/// Reads a table. Throws InputError, as parse_section_times() does.
std::vector<SectionTime> read_section_times(const std::filesystem::path& file);

/// A shipped three-axis machine whose control the model describes; default_machine if there is none.
std::string usual_machine_of(const std::string& model);

/// Sorts models by agreement with the recordings, best first.
void sort_by_explanation(std::vector<Identification>& models);
/// Whether a model roughly explains recordings that `best` explains much better: its residuals are more than
/// twice as large.
bool explains_roughly(const Identification& found, const Identification& best);

/// Result as a machine, with the source of every number, named after its file; "-" for none. If the model
/// does not explain the recordings, the start values are kept.
Machine identified_machine(const Identification& found, const std::filesystem::path& file);

/// Date such as "2026-11-25", for IdentifyOptions::date.
std::string date_of_today();

}  // namespace feedscope
