#include "core/export/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/analysis/study/fastest_runs.h"
#include "core/base/error.h"
#include "core/export/csv_field.h"

namespace feedscope {
namespace {

using Json = nlohmann::ordered_json;

/// A value of a file, with its place.
class Place {
 public:
  Place(const std::string& file, const Json& json, std::string path = "")
      : file_(file), json_(json), path_(std::move(path)) {}

  Place at(const std::string& key) const {
    if (!json_.is_object() || !json_.contains(key)) {
      throw InputError(fmt::format("'{}': key '{}' is missing; merge files written by compare --json", file_,
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
  std::size_t count() const {
    if (!json_.is_number_unsigned()) {
      refuse("a whole number from 0");
    }
    return json_.get<std::size_t>();
  }
  std::string text() const {
    if (!json_.is_string()) {
      refuse("a string");
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
    // If programs have their own tolerances, one setting represents several.
    const bool own = json.contains("tolerance_set_by") && json["tolerance_set_by"] != "setting" &&
                     json["tolerance_set_by"].is_string();
    parts.push_back(own ? std::string("tolerance=program")
                        : fmt::format("tolerance={}", settings["contour_tolerance_mm"].dump()));
  }
  return fmt::format("{}", fmt::join(parts, " "));
}

std::size_t errors_of(const Place& whole) {
  std::size_t count = 0;
  for (const Place& diagnostic : whole.at("diagnostics").list()) {
    count += diagnostic.at("severity").text() == "error" ? 1 : 0;
  }
  return count;
}

/// Bound used for a study.
std::optional<double> bound_of(const Place& whole) {
  const Json& json = whole.json();
  return json.contains("within_mm") && !json["within_mm"].is_null()
             ? std::optional(whole.at("within_mm").number())
             : std::nullopt;
}

MergedRun run_of(const Place& run) {
  MergedRun merged;
  merged.machine = run.at("machine").at("id").text();
  merged.model = run.at("model").at("id").text();
  merged.setting = setting_of(run);
  merged.key = fmt::format("{}\n{}\n{}\n{}", merged.machine, merged.model, run.at("settings").json().dump(),
                           run.at("limits").json().dump());
  merged.refused = run.at("cycle_time_s").json().is_null();
  if (run.json().contains("lines_not_run")) {  // absent in older files
    merged.lines_not_run = run.at("lines_not_run").count();
  }
  if (merged.refused) {
    return merged;
  }
  merged.cycle_time = run.at("cycle_time_s").number();
  merged.mean_feed = run.at("mean_feed_mm_min").number();
  merged.max_contour_error = run.at("max_contour_error_mm").number();
  const char* const cutting = "max_contour_error_cutting_mm";  // absent in older files
  merged.cutting_contour_error =
      run.json().contains(cutting) ? run.at(cutting).number() : merged.max_contour_error;
  return merged;
}

/// Place of a byte in a text as "line 3, column 7"; bytes count from 1.
std::string place_of_byte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 without one
  return fmt::format("line {}, column {}", std::ranges::count(before, '\n') + 1,
                     before.size() - line_begin + 1);
}

/// Throws InputError; also for deep nesting, since functions on JSON are recursive.
Json parsed(const NamedText& file) {
  constexpr int deepest = 64;
  const auto check_depth = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest) {
      throw InputError(fmt::format(
          "'{}': nested deeper than {} levels; merge files written by compare --json", file.name, deepest));
    }
    return true;
  };
  try {
    return Json::parse(file.text, check_depth);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("'{}': not valid JSON, {}{}; merge files written by compare --json",
                                 file.name, error.byte > file.text.size() ? "unexpected end: " : "error at ",
                                 place_of_byte(file.text, error.byte)));
  } catch (const Json::out_of_range&) {
    throw InputError(
        fmt::format("'{}': a number is too large; merge files written by compare --json", file.name));
  }
}

MergedProgram program_of(const NamedText& file, std::optional<double>& within) {
  const Json json = parsed(file);
  const Place whole(file.name, json);
  MergedProgram program;
  program.file = whole.at("program").at("file").text();
  program.segments = whole.at("program").at("segments").count();
  program.errors = errors_of(whole);
  within = bound_of(whole);
  for (const Place& run : whole.at("runs").list()) {
    program.runs.push_back(run_of(run));
    const auto& added = program.runs.back();
    const auto same = std::ranges::find(program.runs, added.key, &MergedRun::key);
    if (same + 1 != program.runs.end()) {
      throw InputError(fmt::format("'{}': runs[{}] has the same settings as runs[{}] ({} {} {})", file.name,
                                   program.runs.size() - 1, same - program.runs.begin(), added.machine,
                                   added.model, added.setting));
    }
  }
  return program;
}

/// Null if the control refuses the program.
Json figure_json(const MergedRun& run, double value) {
  return run.refused ? Json() : Json(value);
}

Json figures_json(const MergedRun& run) {
  return {{"machine", run.machine},
          {"model", run.model},
          {"setting", run.setting},
          {"cycle_time_s", figure_json(run, run.cycle_time)},
          {"max_contour_error_mm", figure_json(run, run.max_contour_error)}};
}

/// Sets within_bound and fastest of a row; null without a bound.
void add_marks(Json& row, const MergedComparison& merged, const MergedRun& run, bool fastest) {
  row["within_bound"] = merged.within && !run.refused ? Json(merged.keeps(run)) : Json();
  row["fastest"] = merged.within ? Json(fastest) : Json();
}

std::string marks_csv(const MergedComparison& merged, const MergedRun& run, bool fastest) {
  return !merged.within ? ","
         : run.refused  ? fmt::format(",{:d}", fastest)
                        : fmt::format("{:d},{:d}", merged.keeps(run), fastest);
}

std::string csv_row(const std::string& program, const MergedRun& run, std::size_t programs, bool has_feed) {
  const auto figure = [&](double value) { return run.refused ? "" : fmt::format("{:.11g}", value); };
  return fmt::format("{},{},{},{},{},{},{},{}", csv_field(program), csv_field(run.machine), run.model,
                     csv_field(run.setting), programs, figure(run.cycle_time),
                     has_feed ? figure(run.mean_feed) : "", figure(run.max_contour_error));
}

RunTime time_of(const MergedRun& run, bool competes) {
  return {run.cycle_time, run.cutting_contour_error, run.lines_not_run, competes && !run.refused};
}

std::vector<bool> marks_of(const std::vector<RunTime>& times, std::optional<double> within) {
  std::vector<bool> marks(times.size());
  for (const std::size_t i : fastest_runs(times, within)) {
    marks[i] = true;
  }
  return marks;
}

void add_to_sums(std::vector<MergedSum>& sums, const MergedRun& run) {
  auto sum = std::ranges::find(sums, run.key, [](const MergedSum& s) { return s.run.key; });
  if (sum == sums.end()) {
    sum = sums.insert(sum, {run, 0});
    sum->run.cycle_time = sum->run.max_contour_error = sum->run.cutting_contour_error = 0;
    sum->run.mean_feed = 0;
    sum->run.refused = true;
    sum->run.lines_not_run = 0;
  }
  if (sum->run.setting != run.setting) {
    sum->run.setting = "tolerance=program or setting";
  }
  if (run.refused) {
    return;
  }
  sum->run.refused = false;
  sum->run.lines_not_run += run.lines_not_run;
  sum->run.cycle_time += run.cycle_time;
  sum->run.max_contour_error = std::max(sum->run.max_contour_error, run.max_contour_error);
  sum->run.cutting_contour_error = std::max(sum->run.cutting_contour_error, run.cutting_contour_error);
  ++sum->programs;
}

}  // namespace

bool MergedComparison::keeps(const MergedRun& run) const {
  return !run.refused && keeps_bound(run.cutting_contour_error, within);
}

std::vector<bool> MergedComparison::fastest(const MergedProgram& program) const {
  std::vector<RunTime> times;
  for (const MergedRun& run : program.runs) {
    times.push_back(time_of(run, within && program.segments > 0));
  }
  return marks_of(times, within);
}

std::vector<bool> MergedComparison::fastest_sums() const {
  std::vector<RunTime> times;
  for (const MergedSum& sum : sums) {
    times.push_back(time_of(sum.run, within && sum.programs == programs.size()));
  }
  return marks_of(times, within);
}

const MergedSum* MergedComparison::fastest_sum() const {
  const std::vector<bool> marks = fastest_sums();
  const auto first = std::ranges::find(marks, true);
  return first == marks.end() ? nullptr : &sums[static_cast<std::size_t>(first - marks.begin())];
}

MergedComparison merge_comparisons(const std::vector<NamedText>& files, std::optional<double> within) {
  MergedComparison merged;
  std::vector<std::optional<double>> bounds;
  for (const NamedText& file : files) {
    MergedProgram program = program_of(file, bounds.emplace_back());
    const auto same = std::ranges::find(merged.programs, program.file, &MergedProgram::file);
    if (same != merged.programs.end()) {
      throw InputError(fmt::format("'{}': program '{}' is also in '{}'", file.name, program.file,
                                   files[static_cast<std::size_t>(same - merged.programs.begin())].name));
    }
    for (const MergedRun& run : program.runs) {
      add_to_sums(merged.sums, run);
    }
    merged.programs.push_back(std::move(program));
  }
  const bool one_bound = !bounds.empty() && std::ranges::count(bounds, bounds.front()) ==
                                                static_cast<std::ptrdiff_t>(bounds.size());
  merged.within = within ? within : one_bound ? bounds.front() : std::nullopt;
  return merged;
}

std::string merged_csv(const MergedComparison& merged) {
  std::string text =
      "program,machine,model,setting,programs,cycle_time_s,mean_feed_mm_min,max_contour_error_mm,errors,"
      "segments,"
      "within_bound,fastest\n";
  std::size_t errors = 0;
  std::size_t segments = 0;
  for (const MergedProgram& program : merged.programs) {
    const std::vector<bool> marks = merged.fastest(program);
    for (std::size_t i = 0; i < program.runs.size(); ++i) {
      const MergedRun& run = program.runs[i];
      text += fmt::format("{},{},{},{}\n", csv_row(program.file, run, 1, true), program.errors,
                          program.segments, marks_csv(merged, run, marks[i]));
    }
    errors += program.errors;
    segments += program.segments;
  }
  const std::vector<bool> marks = merged.fastest_sums();
  for (std::size_t i = 0; i < merged.sums.size(); ++i) {
    const MergedSum& sum = merged.sums[i];
    text += fmt::format("{},{},{},{}\n", csv_row(all_programs, sum.run, sum.programs, false), errors,
                        segments, marks_csv(merged, sum.run, marks[i]));
  }
  return text;
}

std::string merged_json(const MergedComparison& merged) {
  Json programs = Json::array();
  for (const MergedProgram& program : merged.programs) {
    const std::vector<bool> marks = merged.fastest(program);
    Json runs = Json::array();
    for (std::size_t i = 0; i < program.runs.size(); ++i) {
      const MergedRun& run = program.runs[i];
      Json row = figures_json(run);
      row["mean_feed_mm_min"] = figure_json(run, run.mean_feed);
      add_marks(row, merged, run, marks[i]);
      runs.push_back(std::move(row));
    }
    programs.push_back({{"file", program.file},
                        {"errors", program.errors},
                        {"segments", program.segments},
                        {"runs", std::move(runs)}});
  }
  const std::vector<bool> marks = merged.fastest_sums();
  Json sums = Json::array();
  for (std::size_t i = 0; i < merged.sums.size(); ++i) {
    const MergedSum& sum = merged.sums[i];
    Json row = figures_json(sum.run);
    row["programs"] = sum.programs;
    add_marks(row, merged, sum.run, marks[i]);
    sums.push_back(std::move(row));
  }
  return Json({{"format", {{"name", "feedscope-merge"}, {"version", 1}}},
               {"programs", std::move(programs)},
               {"sums", std::move(sums)},
               {"within_mm", merged.within ? Json(*merged.within) : Json()}})
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace feedscope
