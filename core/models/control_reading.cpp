#include "core/models/control_reading.h"

#include <utility>

#include "core/base/translatable.h"

namespace feedscope {
namespace {

bool is_rounded_to(const Vec3& exact, const Vec3& rounded) {
  return (exact.cast<float>() - rounded.cast<float>()).isZero(0);
}

bool leads_to_arc(const Toolpath& path, std::size_t i) {
  do {
    ++i;
  } while (i < path.segments.size() && path.segments[i].kind == SegmentKind::dwell);
  return i < path.segments.size() && path.segments[i].kind == SegmentKind::arc;
}

/// Uses the ends of lines in `as_written` where they are equal in 32 bits.
void use_written_ends(Toolpath& path, const Toolpath& as_written) {
  std::size_t next = 0;              // of as_written
  Vec3 rounded_before = path.start;  // end of the previous segment
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    Segment& segment = path.segments[i];
    const Vec3 rounded = segment.end;
    while (next < as_written.segments.size() && as_written.segments[next].line < segment.line) {
      ++next;
    }
    if (segment.kind == SegmentKind::dwell && segment.end == rounded_before) {
      segment.end = path.start_of(i);
    } else if (segment.kind == SegmentKind::line) {
      const bool written = next < as_written.segments.size() &&
                           as_written.segments[next].line == segment.line &&
                           is_rounded_to(as_written.segments[next].end, segment.end);
      if (written && !leads_to_arc(path, i)) {
        segment.end = as_written.segments[next].end;
      }
      segment.length = (segment.end - path.start_of(i)).norm();
    }
    rounded_before = rounded;
  }
}

}  // namespace

SettingSpec refuse_setting() {
  return {
      .key = "refuse",
      .title = QT_TRANSLATE_NOOP("core", "Refuse lines"),
      .explanation = QT_TRANSLATE_NOOP("core",
                                       "on: lines that the control rejects are reported and not run; off: "
                                       "they are run as they are meant."),
      .choices = {"on", "off"},
  };
}

ControlReading reading_of(ReadProgram read, const Toolpath& as_written, bool single_precision) {
  ControlReading reading;
  reading.refused = std::move(read.diagnostics);
  Toolpath path = build_toolpath(read);
  path.source = as_written.source;
  path.path_controls = as_written.path_controls;
  path.spindles = as_written.spindles;
  path.other_axes = as_written.other_axes;
  if (single_precision) {
    use_written_ends(path, as_written);
  }
  std::size_t next = 0;  // of as_written: the first segment after the line
  for (Segment& segment : path.segments) {
    while (next < as_written.segments.size() && as_written.segments[next].line <= segment.line) {
      ++next;
    }
    if (next > 0) {
      segment.path_control = as_written.segments[next - 1].path_control;
      segment.spindle = as_written.segments[next - 1].spindle;
    }
  }
  reading.path = std::make_shared<const Toolpath>(std::move(path));
  return reading;
}

}  // namespace feedscope
