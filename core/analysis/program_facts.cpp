#include "core/analysis/program_facts.h"

#include <algorithm>

namespace feedscope {

ProgramFacts facts_of(const Program& program, const Toolpath& toolpath) {
  ProgramFacts facts;
  facts.lines = program.source->line_count();
  facts.blocks = program.block_count;
  facts.segments = toolpath.segments.size();
  facts.bounds = program.bounds;
  for (const Segment& segment : toolpath.segments) {
    facts.path_length += segment.length;
    facts.rapid_length += segment.rapid ? segment.length : 0;
    facts.dwell_time += segment.dwell;
    facts.arcs += segment.kind == SegmentKind::arc ? 1 : 0;
    facts.dwells += segment.kind == SegmentKind::dwell ? 1 : 0;
    if (segment.feed > 0) {
      facts.least_feed = facts.least_feed > 0 ? std::min(facts.least_feed, segment.feed) : segment.feed;
      facts.largest_feed = std::max(facts.largest_feed, segment.feed);
    }
  }
  return facts;
}

}  // namespace feedscope
