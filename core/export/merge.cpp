#include "core/export/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/export/csv_field.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

/// A value of a file, which knows where it stands.
class Place {
 public:
  Place(const std::string& file, const Json& json, std::string path = "")
      : file_(file), json_(json), path_(std::move(path)) {}

  Place at(const std::string& key) const {
    if (!json_.is_object() || !json_.contains(key)) {
      throw InputError(fmt::format("'{}': key '{}' is missing; merge files that compare --json wrote", file_,
                                   path_.empty() ? key : path_ + "." + key));
    }
    return {file_, json_.at(key), path_.empty() ? key : path_ + "." + key};
  }
  double number() const {
    if (!json_.is_number()) {
      refuse("a number");
    }
    return json_.get<double>();
  }
  std::string text() const {
    if (!json_.is_string()) {
      refuse("a text");
    }
    return json_.get<std::string>();
  }
  std::vector<Place> list() const {
    if (!json_.is_array()) {
      refuse("a list");
    }
    std::vector<Place> places;
    for (std::size_t i = 0; i < json_.size(); ++i) {
      places.emplace_back(file_, json_[i], fmt::format("{}[{}]", path_, i));
    }
    return places;
  }
  const Json& json() const { return json_; }

 private:
  [[noreturn]] void refuse(const char* wanted) const {
    throw InputError(fmt::format("'{}': key '{}' is {}, but must be {}", file_, path_, json_.dump(), wanted));
  }

  const std::string& file_;
  const Json& json_;
  std::string path_;
};

std::string setting_of(const Place& run) {
  const Json& json = run.json();
  std::vector<std::string> parts;
  if (json.contains("swept") && json["swept"].is_object()) {
    for (const auto& [key, value] : json["swept"].items()) {
      parts.push_back(fmt::format("{}={}", key, value.dump()));
    }
  }
  const Json& settings = run.at("settings").json();
  if (parts.empty() && settings.is_object() && settings.contains("contour_tolerance_mm")) {
    parts.push_back(fmt::format("tolerance={}", settings["contour_tolerance_mm"].dump()));
  }
  return fmt::format("{}", fmt::join(parts, " "));
}

MergedRun run_of(const Place& run) {
  MergedRun merged;
  merged.machine = run.at("machine").at("id").text();
  merged.model = run.at("model").at("id").text();
  merged.setting = setting_of(run);
  merged.key = fmt::format("{}\n{}\n{}\n{}", merged.machine, merged.model, run.at("settings").json().dump(),
                           run.at("limits").json().dump());
  merged.cycle_time = run.at("cycle_time_s").number();
  merged.mean_feed = run.at("mean_feed_mm_min").number();
  merged.max_contour_error = run.at("max_contour_error_mm").number();
  return merged;
}

MergedProgram program_of(const NamedText& file) {
  Json json;
  try {
    json = Json::parse(file.text);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("'{}': no JSON: {}", file.name, error.what()));
  }
  const Place whole(file.name, json);
  MergedProgram program;
  program.file = whole.at("program").at("file").text();
  for (const Place& run : whole.at("runs").list()) {
    program.runs.push_back(run_of(run));
    const auto& added = program.runs.back();
    const auto same = std::ranges::find(program.runs, added.key, &MergedRun::key);
    if (same + 1 != program.runs.end()) {
      throw InputError(fmt::format("'{}': runs[{}] has the settings of runs[{}] ({} {} {})", file.name,
                                   program.runs.size() - 1, same - program.runs.begin(), added.machine,
                                   added.model, added.setting));
    }
  }
  return program;
}

Json run_json(const MergedRun& run) {
  return {{"machine", run.machine},
          {"model", run.model},
          {"setting", run.setting},
          {"cycle_time_s", run.cycle_time},
          {"mean_feed_mm_min", run.mean_feed},
          {"max_contour_error_mm", run.max_contour_error}};
}

std::string csv_row(const std::string& program, const MergedRun& run, std::size_t programs, bool has_feed) {
  return fmt::format("{},{},{},{},{},{:.11g},{},{:.11g}\n", csv_field(program), csv_field(run.machine),
                     run.model, csv_field(run.setting), programs, run.cycle_time,
                     has_feed ? fmt::format("{:.11g}", run.mean_feed) : "", run.max_contour_error);
}

}  // namespace

MergedComparison merge_comparisons(const std::vector<NamedText>& files) {
  MergedComparison merged;
  for (const NamedText& file : files) {
    MergedProgram program = program_of(file);
    const auto same = std::ranges::find(merged.programs, program.file, &MergedProgram::file);
    if (same != merged.programs.end()) {
      throw InputError(fmt::format("'{}': program '{}' is in '{}', too", file.name, program.file,
                                   files[static_cast<std::size_t>(same - merged.programs.begin())].name));
    }
    for (const MergedRun& run : program.runs) {
      auto sum = std::ranges::find(merged.sums, run.key, [](const MergedSum& s) { return s.run.key; });
      if (sum == merged.sums.end()) {
        sum = merged.sums.insert(sum, {run, 0});
        sum->run.cycle_time = sum->run.max_contour_error = sum->run.mean_feed = 0;
      }
      sum->run.cycle_time += run.cycle_time;
      sum->run.max_contour_error = std::max(sum->run.max_contour_error, run.max_contour_error);
      ++sum->programs;
    }
    merged.programs.push_back(std::move(program));
  }
  return merged;
}

std::string merged_csv(const MergedComparison& merged) {
  std::string text =
      "program,machine,model,setting,programs,cycle_time_s,mean_feed_mm_min,max_contour_error_mm\n";
  for (const MergedProgram& program : merged.programs) {
    for (const MergedRun& run : program.runs) {
      text += csv_row(program.file, run, 1, true);
    }
  }
  for (const MergedSum& sum : merged.sums) {
    text += csv_row("", sum.run, sum.programs, false);
  }
  return text;
}

std::string merged_json(const MergedComparison& merged) {
  Json programs = Json::array();
  for (const MergedProgram& program : merged.programs) {
    Json runs = Json::array();
    for (const MergedRun& run : program.runs) {
      runs.push_back(run_json(run));
    }
    programs.push_back({{"file", program.file}, {"runs", std::move(runs)}});
  }
  Json sums = Json::array();
  for (const MergedSum& sum : merged.sums) {
    sums.push_back({{"machine", sum.run.machine},
                    {"model", sum.run.model},
                    {"setting", sum.run.setting},
                    {"programs", sum.programs},
                    {"cycle_time_s", sum.run.cycle_time},
                    {"max_contour_error_mm", sum.run.max_contour_error}});
  }
  return Json({{"programs", std::move(programs)}, {"sums", std::move(sums)}})
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace feedscope
