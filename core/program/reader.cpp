#include "core/program/reader.h"

#include <algorithm>
#include <utility>

#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Motions that cycles and curves may make for each line of ReadOptions::repeat_limit: 50 million by default.
constexpr std::uint64_t motions_a_repeat = 25;

}  // namespace

Reader::Reader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress)
    : options_(options),
      progress_(progress),
      path_(program_, log_),
      lines_(source, options_, log_),
      files_(source->folder()),
      tools_(options_, files_, program_, path_, lines_, log_),
      other_axes_(program_, lines_, log_, options_),
      unit_(options_, program_),
      machining_{options_, log_, path_, lines_, tools_, other_axes_, unit_} {
  program_.source = std::move(source);
  program_.given_offsets = options.offsets;
}

ReadProgram Reader::read() {
  program_.motions.reserve(std::min<std::size_t>(program_.source->line_count(), std::size_t{1} << 24));
  while (!lines_.ended()) {
    if (!lines_.advance()) {
      if (lines_.call_depth() == 0) {
        break;
      }
      run_out();
      continue;
    }
    if (!within_run_limit()) {
      break;
    }
    path_.begin_line(lines_.shown_line(), lines_.place(0));
    try {
      run_line(lines_.text().line(lines_.line()));
    } catch (const ReadFault& fault) {
      machining_.report(fault);
    }
    unit_.watch();
  }
  finish();
  path_.finish();
  unit_.finish(log_);
  program_.block_count = lines_.block_count();
  program_.call_count = lines_.call_count();
  report_nothing_read();
  report_text_after_end();
  program_.called_files = files_.all_read();
  program_.diagnostics = log_.take();
  return std::move(program_);
}

bool Reader::within_run_limit() {
  stop_if_cancelled(progress_);  // one line may run a cycle of a hundred thousand moves
  constexpr std::uint64_t lines_between_reports = 4096;
  const std::uint32_t count = program_.source->line_count();
  const std::uint64_t lines_run = lines_.lines_run();
  if (lines_run % lines_between_reports == 0 && progress_ != nullptr) {
    progress_->report(std::min(1.0, static_cast<double>(lines_.shown_line()) / count));
  }
  const std::uint64_t max_motions = count + motions_a_repeat * options_.repeat_limit;
  if (lines_run <= count + options_.repeat_limit && program_.motions.size() <= max_motions) {
    return true;
  }
  program_.cut_off = true;
  if (program_.motions.size() > max_motions) {
    report(Severity::error, "run-limit", 1, 0, [&] {
      return Text{message(NC_("core", "cycles and curves have made more than {} motions"), max_motions),
                  NC_("core",
                      "the rest is skipped; check the infeeds of the cycles, or raise the limit with "
                      "--repeat-limit")};
    });
    return false;
  }
  report(Severity::error, "run-limit", 0, 0, [&] {
    return Text{
        message(NC_("core", "loops and calls have run {} lines without coming to an end"),
                options_.repeat_limit),
        NC_("core",
            "the rest is skipped; check the loop's condition, or raise the limit with --repeat-limit")};
  });
  return false;
}

void Reader::report_nothing_read() {
  if (program_.block_count == 0) {
    log_.add(Severity::error, "empty-program", 0, {}, [] {
      return Text{NC_("core", "the program has no blocks"),
                  NC_("core", "give a file with NC blocks such as \"G1 X10 F500\"")};
    });
  } else if (std::all_of(program_.motions.begin(), program_.motions.end(), [](const MotionBlock& block) {
               return block.motion == Motion::dwell && block.pause != Pause::dwell &&
                      block.pause != Pause::machine_move;
             })) {
    log_.add(Severity::warning, "no-motion", 0, {}, [] {
      return Text{NC_("core", "no block of the program moves an axis"),
                  NC_("core", "if the program has another dialect, give it with --dialect")};
    });
  }
}

void Reader::report_text_after_end() {
  const std::uint32_t end = lines_.end_line();
  if (end == 0 || lines_.last_run() > end) {
    return;
  }
  const SourceText& source = *program_.source;
  for (std::uint32_t line = end + 1; line <= source.line_count(); ++line) {
    if (const std::uint32_t column = first_word(source.line(line)); column > 0) {
      log_.add(Severity::info, "text-after-end", 0, {line, column, {}}, [&] {
        return Text{
            message(NC_("core", "the program ends in line {}; the text after it is not executed"), end), {}};
      });
      return;
    }
  }
}

}  // namespace feedscope
