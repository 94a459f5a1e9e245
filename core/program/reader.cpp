#include "core/program/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Motions that cycles and curves may make for each line that ReadOptions::repeat_limit allows: 50 million if
/// nothing else is asked for.
constexpr std::uint64_t motions_a_repeat = 25;

}  // namespace

Reader::Reader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress)
    : options_(options),
      progress_(progress),
      path_(program_, log_),
      files_(source->folder()),
      cutters_(options, files_),
      text_(source) {
  program_.source = std::move(source);
  program_.given_offsets = options.offsets;
}

Program Reader::read() {
  program_.motions.reserve(std::min<std::size_t>(program_.source->line_count(), std::size_t{1} << 24));
  while (!ended()) {
    if (next_line_ > text_->line_count()) {
      if (calls_.empty()) {
        break;
      }
      run_out();
      continue;
    }
    line_ = next_line_++;
    if (!within_run_limit()) {
      break;
    }
    const std::uint32_t shown = shown_line();
    last_run_ = std::max(last_run_, shown);
    path_.begin_line(shown, place(0));
    try {
      run_line(text_->line(line_));
    } catch (const ReadFault& fault) {
      report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
    }
    watch_unit();
  }
  before_finish();
  finish();
  path_.finish();
  watch_unit();
  settle_unit();
  report_assumed_unit();
  report_nothing_read();
  report_text_after_end();
  program_.called_files = files_.all_read();
  program_.diagnostics = log_.take();
  return std::move(program_);
}

bool Reader::within_run_limit() {
  constexpr std::uint64_t lines_between_reports = 4096;
  const std::uint32_t count = program_.source->line_count();
  if (++lines_run_ % lines_between_reports == 0 && progress_ != nullptr) {
    progress_->report(std::min(1.0, static_cast<double>(shown_line()) / count));
  }
  const std::uint64_t most_motions = count + motions_a_repeat * options_.repeat_limit;
  if (lines_run_ <= count + options_.repeat_limit && program_.motions.size() <= most_motions) {
    return true;
  }
  program_.cut_off = true;
  if (program_.motions.size() > most_motions) {
    report(Severity::error, "run-limit", 1, 0, [&] {
      return Text{
          fmt::format("cycles and curves have made more than {} motions", most_motions),
          "the rest is skipped; check the infeeds of the cycles, or raise the limit with --repeat-limit"};
    });
    return false;
  }
  report(Severity::error, "run-limit", 0, 0, [&] {
    return Text{
        fmt::format("loops and calls have run {} lines without coming to an end", options_.repeat_limit),
        "the rest is skipped; check the loop's condition, or raise the limit with --repeat-limit"};
  });
  return false;
}

/// Until there is a motion with a length; what it was written in is the program's unit.
void Reader::watch_unit() {
  while (!unit_settled_ && first_motion_ < program_.motions.size()) {
    if (program_.motions[first_motion_].motion == Motion::dwell) {
      ++first_motion_;
    } else {
      settle_unit();
    }
  }
}

void Reader::settle_unit() {
  if (unit_settled_) {
    return;
  }
  unit_settled_ = true;
  using Source = ProgramUnit::Source;
  program_.unit = {said_unit_.value_or(first_unit()), said_unit_      ? Source::program
                                                      : options_.unit ? Source::asked
                                                                      : Source::assumed};
}

void Reader::run_out() {
  return_from_call();
}

bool Reader::call(std::shared_ptr<const SourceText> text, std::uint32_t line, std::uint32_t times) {
  if (calls_.size() >= options_.call_depth) {
    report(Severity::error, "call-depth", 0, 0, [&] {
      return Text{fmt::format("calls are nested more than {} deep", options_.call_depth),
                  "this call is skipped; check whether the subprogram calls itself, or raise the limit with "
                  "--call-depth"};
    });
    return false;
  }
  ++program_.call_count;
  calls_.push_back({text_, line_, line, std::max(times, 1U)});
  text_ = std::move(text);
  next_line_ = line;
  return true;
}

bool Reader::return_from_call() {
  if (calls_.empty()) {
    return false;
  }
  Call& last = calls_.back();
  if (--last.times > 0) {
    next_line_ = last.start;
    return true;
  }
  text_ = std::move(last.text);
  next_line_ = last.line + 1;
  calls_.pop_back();
  left_call();
  return true;
}

std::uint32_t Reader::shown_line() const {
  if (text_ == program_.source) {
    return line_;
  }
  const auto from_program = std::find_if(calls_.rbegin(), calls_.rend(),
                                         [this](const Call& call) { return call.text == program_.source; });
  return from_program->line;
}

void Reader::select_tool(std::string_view name) {
  const bool is_new = std::none_of(program_.tools.begin(), program_.tools.end(),
                                   [&](const ToolChange& tool) { return tool.name == name; });
  if (is_new) {
    program_.tools.push_back({std::string(name), shown_line()});
  }
}

void Reader::change_tool(std::string_view name) {
  if (tool_in_spindle_ != name) {
    tool_in_spindle_ = name;
    spindle_turns_ = false;
    path_.pause(Pause::tool_change);
  }
}

void Reader::start_spindle() {
  if (!spindle_turns_) {
    spindle_turns_ = true;
    path_.pause(Pause::spindle_start);
  }
}

void Reader::report_machine_move(std::string_view what, std::string_view code, std::uint32_t column) {
  report(Severity::warning, code, 0, column, [&] {
    return Text{
        fmt::format("{} moves to a machine position, which the program does not contain", what),
        "neither drawn nor timed unless the machine gives positions (home_z_mm, part_zero_z_mm, ...); the "
        "path continues where every axis is programmed again"};
  });
}

std::optional<double> Reader::cutter_radius(std::string_view tool, std::optional<double> programmed) {
  const Cutters::Found found = cutters_.find(tool, programmed);
  return found.source == CutterSource::unknown ? std::nullopt : std::optional(found.radius);
}

std::optional<double> Reader::use_cutter(std::string_view tool, std::optional<double> programmed) {
  const Cutters::Found found = cutters_.find(tool, programmed);
  const std::string key = CutterRadii::key(tool);
  const auto known = std::find_if(program_.cutters.begin(), program_.cutters.end(),
                                  [&](const CutterUse& use) { return use.tool == key; });
  if (known == program_.cutters.end()) {
    program_.cutters.push_back({key, found.radius, shown_line(), found.source});
  } else {
    known->radius = found.radius;
    known->source = found.source;
  }
  if (!cutters_.table_fault().empty()) {
    report(Severity::warning, "tool-table", 0, 0, [&] {
      return Text{cutters_.table_fault(),
                  "the table in the program's folder is not used; correct it, or name another one"};
    });
  } else if (found.source == CutterSource::table) {
    report(Severity::info, "tool-table", 1, 0, [&] {
      return Text{fmt::format("cutter radii are those of tool table '{}'", cutters_.table_name()), ""};
    });
  }
  return found.source == CutterSource::unknown ? std::nullopt : std::optional(found.radius);
}

void Reader::note_other_axis(std::string_view axis, double target, AxisMotion motion, std::uint32_t column) {
  auto known = std::find_if(other_axes_.begin(), other_axes_.end(),
                            [&](const OtherAxis& other) { return other.name == axis; });
  if (known == other_axes_.end()) {
    program_.other_axes.emplace_back(axis);
    known = other_axes_.insert(known, {std::string(axis), {}});
  }
  if (std::exchange(known->said[static_cast<std::size_t>(motion)], true)) {
    return;
  }
  const Severity severity = motion == AxisMotion::cuts ? Severity::error : Severity::warning;
  const std::string_view path = motion == AxisMotion::at_tip
                                    ? "X, Y and Z are those of the tool's tip and shown as programmed"
                                    : "X, Y and Z are shown as programmed";
  const int kind = static_cast<int>(motion) + 3 * static_cast<int>(known - other_axes_.begin());
  report(severity, "unread-axis", kind, column, [&] {
    return Text{fmt::format("{}{} moves to {}{}, which is not simulated",
                            axis.find(' ') == std::string_view::npos ? "axis " : "", axis, target,
                            motion == AxisMotion::positions ? "" : " in a feed move"),
                fmt::format("{}; the time of this axis is not counted, so the cycle time is too short; "
                            "reported once",
                            path)};
  });
}

namespace {

CutSize cut_size(const Program& program) {
  CutSize cut;
  for (const MotionBlock& motion : program.motions) {
    if (motion.motion == Motion::line || motion.motion == Motion::arc) {
      cut.feed = std::max(cut.feed, motion.feed);
    }
  }
  const Bounds& bounds = program.cutting_bounds;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = bounds.max[axis] - bounds.min[axis];
    cut.size[axis] = std::isfinite(size) ? size : 0;
  }
  return cut;
}

}  // namespace

/// grbl and printers start in mm whatever the machine; only sizes that look like inches are worth a word.
void Reader::report_assumed_unit() {
  if (program_.unit.source != ProgramUnit::Source::assumed || first_motion_ >= program_.motions.size()) {
    return;
  }
  const CutSize cut = cut_size(program_);
  const bool inches = looks_like_inches(cut);
  if (options_.dialect == Dialect::grbl && !inches) {
    return;
  }
  std::string hint = "give it as a reading option: --unit mm or --unit inch";
  if (inches) {
    hint = fmt::format(
        "{:.4g} x {:.4g} x {:.4g} mm cut at {:.4g} mm/min at most look like inches; give --unit inch, or "
        "--unit mm "
        "if that is right",
        cut.size.x(), cut.size.y(), cut.size.z(), units::to_mm_min(cut.feed));
  }
  log_.add(Severity::warning, "unit-assumed", 0, {program_.motions[first_motion_].line, 0, {}}, [&] {
    return Text{"the program does not say its unit; mm is used", hint};
  });
}

std::string Reader::radius_hint(std::string_view tool) {
  return fmt::format(
      "give it as an import option (--tool {}=RADIUS) or in a tool table, or say that the path is "
      "already compensated (--wear-only)",
      CutterRadii::key(tool));
}

DiagnosticLog::Place Reader::place(std::uint32_t column) const {
  return {line_, column, text_ == program_.source ? std::string_view() : std::string_view(text_->name())};
}

void Reader::report_nothing_read() {
  if (program_.block_count == 0) {
    log_.add(Severity::error, "empty-program", 0, {}, [] {
      return Text{"the program holds no blocks", "give a file with NC blocks such as \"G1 X10 F500\""};
    });
  } else if (std::all_of(program_.motions.begin(), program_.motions.end(), [](const MotionBlock& block) {
               return block.motion == Motion::dwell && block.pause != Pause::dwell &&
                      block.pause != Pause::machine_move;
             })) {
    log_.add(Severity::warning, "no-motion", 0, {}, [] {
      return Text{"no block of the program moves",
                  "if the program is another dialect's, name it with --dialect"};
    });
  }
}

void Reader::report_text_after_end() {
  if (end_line_ == 0 || last_run_ > end_line_) {
    return;
  }
  const SourceText& source = *program_.source;
  for (std::uint32_t line = end_line_ + 1; line <= source.line_count(); ++line) {
    if (const std::uint32_t column = first_word(source.line(line)); column > 0) {
      log_.add(Severity::info, "text-after-end", 0, {line, column, {}}, [&] {
        return Text{fmt::format("the program ends in line {}; what follows is not executed", end_line_), ""};
      });
      return;
    }
  }
}

}  // namespace feedscope
