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

/// What a machine recorded, each with the program that ran: traces and tables of section times, to be
/// explained by one control model after the other.
class Recordings {
 public:
  /// What the next stage of the work is reported to, by its title for people: "matching", "fitting"; null for
  /// nobody.
  using Stage = std::function<Progress*(const char* title)>;

  void add(std::shared_ptr<const Trace> trace, const LoadedProgram& program);
  void add(std::vector<SectionTime> times, const std::string& name, const LoadedProgram& program);
  std::size_t size() const { return items_.size(); }
  /// What is looked for without being asked for: usual_fit_parameters(), and the drives of the axes whose set
  /// and actual positions are recorded.
  std::vector<FitParameter> usual_parameters(const Setup& start) const;

  /// The `parameters` of `start` with which its model explains all of them best; those of drives by
  /// fit_drive(). If its model does not explain them, a tolerance that may be zero, for no limit, is tried
  /// so. If all traces run at one share of the programmed feed, that is taken as the feed override. Throws
  /// InputError for a recording that is not of its program, holds too little of it or has a wrong rate, for
  /// section times that no machine takes (SectionCase::check_times()), for a drive without set and actual
  /// positions, and what identify() throws.
  Identification fit(const Setup& start, const std::vector<FitParameter>& parameters,
                     const IdentifyOptions& options = {}, const Stage& stage = {});
  /// What is wrong with each of them on its program: known after fit(), of tables nothing.
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

  /// A drive that was found: no model of the control changes it.
  struct FoundDrive {
    AxisDrive start;
    FreeDriveNumbers free;
    DriveFit fit;
  };

  std::vector<Item> items_;
  std::deque<FoundDrive> drives_;
  std::vector<std::vector<Diagnostic>> remarks_;
  std::vector<std::optional<double>> feed_shares_;  ///< of each; of tables none
};

/// Numbers that usual_fit_parameters() would have looked for and that were held, by their keys: where a model
/// does not explain recordings, they may be what is wrong.
std::vector<std::string> held_parameters(const Identification& found);

/// Whether a file is a table of section times; false for one that cannot be read.
bool is_section_times_file(const std::filesystem::path& file);
/// Reads one. Throws InputError, as parse_section_times().
std::vector<SectionTime> read_section_times(const std::filesystem::path& file);

/// A shipped machine of three axes whose control a model is of; default_machine if there is none.
std::string usual_machine_of(const std::string& model);

/// The model that explains the recordings best first.
void sort_by_explanation(std::vector<Identification>& models);
/// Whether a model comes near the recordings that `best` explains much better: it leaves more than twice as
/// much over.
bool explains_roughly(const Identification& found, const Identification& best);

/// What was found as a machine, with the source of every number, named after the file that it goes to; "-"
/// for none. Of a model that does not explain the recordings it keeps the values that were begun with.
Machine identified_machine(const Identification& found, const std::filesystem::path& file);

/// "2026-11-25", for IdentifyOptions::date.
std::string date_of_today();

}  // namespace feedscope
