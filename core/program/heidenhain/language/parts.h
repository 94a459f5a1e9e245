#pragma once

#include "core/program/heidenhain/cycles/cycle_calls.h"
#include "core/program/heidenhain/geometry/approaches.h"
#include "core/program/heidenhain/geometry/blank.h"
#include "core/program/heidenhain/geometry/dwells.h"
#include "core/program/heidenhain/language/q_functions.h"
#include "core/program/heidenhain/language/system_data.h"

namespace feedscope::heidenhain {

/// Parts shared by the two languages of the control: contours, tools, cycles, labels, calls, parameters. Each
/// language turns its statements into calls of these parts.
struct Parts {
  /// All outlive it.
  Parts(Machining& machining, Dialect dialect, SubprogramFiles& files, Labels::OfLine label_of_line)
      : context(machining, dialect),
        labels(context, std::move(label_of_line)),
        calls(context, labels, files),
        feeds(context),
        tools(context, labels, feeds),
        targets(context, feeds),
        coordinates(context),
        path_modes(context),
        dwells(context),
        blank(context),
        cycle_parameters(context),
        pattern_cycles(context, cycle_parameters),
        cycles(context, cycle_parameters, pattern_cycles, coordinates, calls),
        m_functions(context, {feeds, tools, targets, path_modes, cycles, calls}),
        motions(context, feeds, tools, targets, m_functions),
        approaches(context, feeds, tools, targets, m_functions, motions),
        cycle_calls(context, cycle_parameters, cycles, targets, motions),
        q_functions(context, calls),
        system_data(context, tools, targets, coordinates) {}

  Context context;
  Labels labels;
  Calls calls;
  Feeds feeds;
  Tools tools;
  Targets targets;
  Coordinates coordinates;
  PathModes path_modes;
  Dwells dwells;
  Blank blank;
  CycleParameters cycle_parameters;
  PatternCycles pattern_cycles;
  Cycles cycles;
  MFunctions m_functions;
  Motions motions;
  Approaches approaches;
  CycleCalls cycle_calls;
  QFunctions q_functions;
  SystemData system_data;
};

}  // namespace feedscope::heidenhain
