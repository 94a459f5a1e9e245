#include "core/analysis/run/program_facts.h"

#include <algorithm>

namespace feedscope {

namespace {

/// As many as a reader would look through; loops may change the settings at every pass.
constexpr std::size_t max_ranges = 200;

std::vector<PathControlRange> path_control_ranges(const Toolpath& toolpath) {
  std::vector<PathControlRange> ranges;
  std::uint16_t last = 0;
  for (const Segment& segment : toolpath.segments) {
    if (segment.kind == SegmentKind::dwell) {
      continue;
    }
    if (ranges.empty() || segment.path_control != last) {
      if (ranges.size() == max_ranges) {
        break;
      }
      ranges.push_back({segment.line, segment.line, toolpath.path_controls[segment.path_control]});
      last = segment.path_control;
    }
    ranges.back().first_line = std::min(ranges.back().first_line, segment.line);
    ranges.back().last_line = std::max(ranges.back().last_line, segment.line);
  }
  return ranges;
}

bool is_dwell(const Toolpath& toolpath, const Segment& segment) {
  return segment.kind == SegmentKind::dwell && toolpath.pause_of(segment).kind == Pause::dwell;
}

}  // namespace

ProgramFacts facts_of(const Program& program, const Toolpath& toolpath) {
  ProgramFacts facts;
  facts.lines = program.source->line_count();
  facts.blocks = program.block_count;
  facts.bounds = program.bounds;
  facts.cutting_bounds = program.cutting_bounds;
  facts.rapid_bounds = program.rapid_bounds;
  facts.path_control = path_control_ranges(toolpath);
  facts.not_counted = not_counted(toolpath);
  facts.chord_error = chord_error_of(toolpath);
  for (const Segment& segment : toolpath.segments) {
    facts.segments += segment.kind != SegmentKind::dwell || is_dwell(toolpath, segment) ? 1 : 0;
    facts.path_length += segment.length;
    facts.rapid_length += segment.rapid ? segment.length : 0;
    facts.dwell_time += segment.kind == SegmentKind::dwell ? toolpath.dwell_of(segment) : 0;
    facts.arcs += segment.kind == SegmentKind::arc ? 1 : 0;
    facts.dwells += is_dwell(toolpath, segment) ? 1 : 0;
    if (segment.feed > 0) {
      facts.min_feed = facts.min_feed > 0 ? std::min(facts.min_feed, segment.feed) : segment.feed;
      facts.largest_feed = std::max(facts.largest_feed, segment.feed);
    }
  }
  return facts;
}

}  // namespace feedscope
