#include "core/models/control_reading.h"

#include <utility>

#include "core/base/translatable.h"

namespace feedscope {

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

ControlReading reading_of(Program read, const Toolpath& as_written) {
  ControlReading reading;
  reading.refused = std::move(read.diagnostics);
  Toolpath path = take_toolpath(read);
  path.source = as_written.source;
  path.read_by_control = true;
  path.path_controls = as_written.path_controls;
  path.spindles = as_written.spindles;
  path.other_axes = as_written.other_axes;
  std::size_t next = 0;  // of as_written: the first segment behind the line
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
