#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/run/run.h"
#include "core/base/dimension.h"
#include "core/base/message.h"

namespace feedscope {

/// A fact that the figures of a run do not show and that restricts their use, as one sentence.
struct Remark {
  enum class About : std::uint8_t {
    validity,      ///< the machine would not run this: another control, other work offsets, refused lines
    faults,        ///< positions of rotary axes, which are also among the messages
    path_control,  ///< requests of the program that the run does not follow
    drives,        ///< of the machine
    programmed,    ///< meaning of programmed feeds and times
    time,          ///< doubts about the cycle time
    values,        ///< meaning of the largest values
    not_counted,   ///< events without a time; tables of figures have them as a row
  };
  About about = About::validity;
  Message text;
};

/// All remarks on a run that apply, in a fixed order, with amounts in `units`. Every output of a run takes
/// its remarks from here.
std::vector<Remark> remarks(const Run& run, UnitSystem units = UnitSystem::metric);
/// Texts of the remarks on these topics.
std::vector<Message> texts_about(std::span<const Remark> remarks,
                                 std::initializer_list<Remark::About> topics);

/// Remarks on the damping of drives and on axes without one.
std::vector<Message> drive_remarks(const Machine& machine);

/// Work offsets in the machine file that the program uses but was not read with, as when several machines run
/// it: "G54, G55"; empty if none.
std::string unused_work_offsets(const Program& program, const Machine& machine);

/// Largest feed of `program`, with the override of the setup, if the machine cannot reach it in any
/// direction; `path`: as the machine runs it.
std::optional<UnreachableFeed> feed_beyond_machine(const LoadedProgram& program, const Toolpath& path,
                                                   const Setup& setup);

}  // namespace feedscope
