#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "app/run_options.h"
#include "core/analysis/notes/remarks.h"
#include "core/analysis/run/run.h"

namespace feedscope {

/// A setup and the remarks on its run.
struct RemarkedSetup {
  const Setup* setup = nullptr;
  std::vector<Remark> remarks;
};
/// Prints remarks that concern program, control and machine to standard error, each once, with the machines
/// or models if it is not one on all `runs`. Those on figures are printed with these.
void note_remarks(std::span<const RemarkedSetup> runs);
/// The remarks on these topics, each once in a sentence of its own, likewise with its machines or models.
std::vector<std::string> remark_texts(std::span<const RemarkedSetup> runs,
                                      std::initializer_list<Remark::About> topics);

/// Prints to standard error all that is to be known of one run: whether `asked` replaces the program's
/// tolerances, the unused part of `reading`, note_remarks(), and print_messages().
void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading);
/// Prints to standard error the messages on the program of a run, on refused lines and on positions or
/// motions that the machine cannot do.
void print_messages(const Run& run);
/// exit_code::program_errors for a run with errors in its program or positions out of the machine's reach.
int exit_code_of(const Run& run);

}  // namespace feedscope
