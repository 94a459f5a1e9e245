
#include <algorithm>
#include <iterator>

#include "core/analysis/agreement/trace_likeness.h"
#include "core/analysis/agreement/trace_on_program.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double as_good_as_whole = 0.99;

Diagnostic remark(Severity severity, std::string code, Message what, Message hint) {
  return {.severity = severity,
          .line = 0,
          .column = 0,
          .code = std::move(code),
          .message = std::move(what),
          .hint = std::move(hint)};
}

/// Axis names as a list: "X", "X and Z", "X, Y and Z".
Message names_of(const SeenAxes& axes) {
  std::vector<Message> names;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if (axes[axis]) {
      names.push_back(Message::as_written(std::string(1, coordinate_names[axis])));
    }
  }
  return listed(names);
}

/// Lines as text: "line 5", "lines 5 to 9".
Message lines_text(const ProgrammedCourse& course, double from_s, double to_s) {
  const std::uint32_t first = course.line_at(from_s);
  const std::uint32_t last = course.line_at(to_s);
  return first == last ? message(NC_("core", "line {}"), first)
                       : message(NC_("core", "lines {} to {}"), first, last);
}

void add_pose(std::vector<Diagnostic>& remarks, const TracePose& pose) {
  if (pose.scale > 1) {
    remarks.push_back(
        remark(Severity::warning, "trace-inches",
               NC_("core", "the trace is in inches; it is used as 25.4 times what it says"),
               NC_("core", "give its columns the unit, as --columns x=2:in, where that is right")));
  } else if (pose.scale < 1) {
    remarks.push_back(remark(
        Severity::warning, "trace-inches",
        NC_("core", "the trace is 25.4 times as large as the program; it is used as that part of it"),
        NC_("core",
            "its positions are in mm, not in inches: say so, as --columns x=2:mm, where that is right")));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (pose.mirror[axis] < 0) {
      remarks.push_back(
          remark(Severity::warning, "trace-mirrored",
                 message(NC_("core", "axis {} of the trace is mirrored; it is used with the other sign"),
                         coordinate_names[static_cast<std::size_t>(axis)]),
                 NC_("core", "give its column a minus sign, as --columns x=2:-mm, where that is right")));
    }
  }
}

/// Axes that the program moves and the trace does not have, or does not move.
void add_axes(std::vector<Diagnostic>& remarks, const TraceOnProgram& found, const Trace& trace,
              const ProgrammedCourse& course) {
  constexpr double noticed = 1e-3;  // [mm]
  SeenAxes missing{};
  SeenAxes there{};
  for (std::size_t axis = 0; axis < missing.size(); ++axis) {
    there[axis] = trace.has(axis);
    missing[axis] = !trace.has(axis) && course.moves(axis);
    if (!there[axis] || found.belongs()) {
      continue;
    }
    const auto [low, high] = std::ranges::minmax_element(trace.place[axis]);
    const double moved =
        course.bounds().max[static_cast<int>(axis)] - course.bounds().min[static_cast<int>(axis)];
    if (*high - *low < noticed && moved > found.tolerance) {
      remarks.push_back(
          remark(Severity::warning, "trace-axis-still",
                 message(NC_("core", "axis {} does not move in the trace, but by {:.4g} mm in the program"),
                         coordinate_names[axis], moved),
                 NC_("core",
                     "if it was not recorded, name the columns of the others alone, as --columns time=1,x=2: "
                     "times and the motion of these axes can be compared then")));
    }
  }
  if (std::ranges::count(missing, true) > 0) {
    remarks.push_back(remark(
        Severity::warning, "trace-axes",
        message(NC_("core",
                    "the trace does not have {}, which the program moves: feeds, corners and distances are "
                    "those of {} alone"),
                names_of(missing), names_of(there)),
        NC_("core",
            "times and limits of the axes that are there can be told; record X, Y and Z for the others")));
  }
}

void add_lost(std::vector<Diagnostic>& remarks, const TraceOnProgram& found, const ProgrammedCourse& course) {
  for (const bool recorded : {true, false}) {
    double time = 0;
    std::size_t count = 0;
    LostStretch longest;
    for (const LostStretch& stretch : found.lost) {
      if (stretch.recorded == recorded && !stretch.jumps) {  // jumps get their own remark
        time += stretch.to - stretch.from;
        ++count;
        longest = stretch.to - stretch.from > longest.to - longest.from ? stretch : longest;
      }
    }
    if (count == 0) {
      continue;
    }
    const Message at = lines_text(course, longest.from_s, longest.to_s);
    const Message place =
        count == 1 ? message(NC_("core", "{:.4g} s from {:.4g} s on at {}"), time, longest.from, at)
                   : message(NC_("core", "{:.4g} s in {} stretches, the longest from {:.4g} s on at {}"),
                             time, count, longest.from, at);
    if (recorded) {
      remarks.push_back(remark(
          Severity::warning, "trace-off-path",
          message(NC_("core", "the trace is farther than {:.3g} mm from the path of the program for {}"),
                  found.tolerance, place),
          NC_("core",
              "they are marked and their feeds not compared; the control did there what the program does not "
              "say")));
    } else {
      remarks.push_back(remark(
          Severity::warning, "trace-unknown", message(NC_("core", "nothing was recorded for {}"), place),
          NC_("core", "the time of the whole is right; feeds, ramps and corners there are not known")));
    }
  }
}

}  // namespace

std::vector<Diagnostic> remarks_on(const TraceOnProgram& found, const Trace& trace,
                                   const ProgrammedCourse& course) {
  std::vector<Diagnostic> remarks;
  const std::vector<Diagnostic> likeness =
      found.belongs() ? std::vector<Diagnostic>() : likeness_remarks(course, record_of(trace));
  if (!found.belongs() && (found.fit.way > 0 || likeness.empty())) {
    remarks.push_back(
        found.fit.way > 0
            ? remark(Severity::warning, "trace-other-program",
                     message(NC_("core",
                                 "the trace does not belong to this program: {:.1f} % of its way runs along "
                                 "the path, and along {:.1f} % of it"),
                             100 * found.fit.trace_share, 100 * found.fit.path_share),
                     NC_("core",
                         "open the program that was recorded, or give the zero point it ran with; times and "
                         "feeds of the two tell nothing together"))
            : remark(Severity::warning, "trace-still", NC_("core", "the trace does not move"),
                     NC_("core", "record while the program runs, and check the columns of the positions")));
  }
  std::ranges::copy(likeness, std::back_inserter(remarks));
  add_pose(remarks, found.pose);
  add_axes(remarks, found, trace, course);
  if (!found.belongs() || found.law.empty()) {
    return remarks;
  }
  add_lost(remarks, found, course);
  const double reached =
      course.length() > 0 ? (found.law.last_s() - found.law.first_s()) / course.length() : 1;
  if (reached < as_good_as_whole) {
    remarks.push_back(remark(
        Severity::warning, "trace-part",
        message(
            NC_("core", "the trace covers {:.1f} % of the path of the program, {}; only that is compared"),
            100 * reached, lines_text(course, found.law.first_s(), found.law.last_s())),
        NC_("core",
            "feeds, ramps and corners there can be compared and limits be told; the cycle time is not "
            "known")));
  }
  if (found.pass_times.size() > 1) {
    remarks.push_back(
        remark(Severity::info, "trace-passes",
               message(NC_("core", "the trace holds {} passes through the program; the first is compared"),
                       found.pass_times.size()),
               {}));
  }
  return remarks;
}

}  // namespace feedscope
