#include "app/run_remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_codes.h"
#include "app/print.h"
#include "core/analysis/notes/refused_lines.h"

namespace feedscope {
namespace {

std::string model_name(const Setup& setup) {
  return fmt::format("'{}'", setup.model->info().id);
}

std::string machine_name(const Setup& setup) {
  return fmt::format("'{}'", setup.machine.id);
}

std::string run_name(const Setup& setup) {
  return model_name(setup) + " on " + machine_name(setup);
}

/// Prefix that names some of several runs, by machine or model if all runs with these are among them: "models
/// 'essid', 'ward': ". Empty for all runs.
std::string names_of(const std::vector<bool>& chosen, std::span<const RemarkedSetup> runs) {
  if (std::ranges::find(chosen, false) == chosen.end()) {
    return {};
  }
  struct Naming {
    const char* kind;
    std::string (*name)(const Setup&);
  };
  for (const auto& [kind, name] :
       {Naming{"machine", machine_name}, Naming{"model", model_name}, Naming{"model", run_name}}) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (std::string one = name(*runs[i].setup); chosen[i] && std::ranges::find(names, one) == names.end()) {
        names.push_back(std::move(one));
      }
    }
    const auto is_named = [&, name = name](const RemarkedSetup& run) {
      return std::ranges::find(names, name(*run.setup)) != names.end();
    };
    const auto named = static_cast<std::ptrdiff_t>(std::ranges::count_if(runs, is_named));
    if (named == std::ranges::count(chosen, true) || name == run_name) {
      return fmt::format("{}{} {}: ", kind, names.size() > 1 ? "s" : "", fmt::join(names, ", "));
    }
  }
  return {};
}

}  // namespace

std::vector<std::string> remark_texts(std::span<const RemarkedSetup> runs,
                                      std::initializer_list<Remark::About> topics) {
  std::vector<std::pair<Message, std::vector<bool>>> notes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const Message& text : texts_about(runs[i].remarks, topics)) {
      auto note = std::ranges::find(notes, text, &std::pair<Message, std::vector<bool>>::first);
      if (note == notes.end()) {
        note = notes.insert(notes.end(), {text, std::vector<bool>(runs.size())});
      }
      note->second[i] = true;
    }
  }
  std::vector<std::string> texts;
  for (const auto& [text, chosen] : notes) {
    texts.push_back(names_of(chosen, runs) + text.english());
  }
  return texts;
}

void note_remarks(std::span<const RemarkedSetup> runs) {
  using About = Remark::About;
  for (const std::string& text : remark_texts(runs, {About::validity, About::path_control, About::drives})) {
    fmt::print(stderr, "feedscope: note: {}\n", text);
  }
}

void tell_of_run(const Run& run, const RunOptions& asked, const ReadOptions& reading) {
  if (!asked.tolerance.empty()) {
    note_unused_tolerances({asked.tolerance}, {run.setup});
    note_replaced_tolerance(*run.path, {run.setup});
  }
  note_unused_reading(*run.input.program, reading);
  const RemarkedSetup remarked{&run.setup, remarks(run)};
  note_remarks({&remarked, 1});
  print_messages(run);
}

void print_messages(const Run& run) {
  print_diagnostics(*run.input.program);
  print_diagnostics(run.lines_not_run, *run.input.program);
  print_diagnostics(run.path.faults, *run.input.program);
}

int exit_code_of(const Run& run) {
  return has_errors(run.input.program->diagnostics) || is_out_of_reach(run) ? exit_code::program_errors
                                                                            : exit_code::done;
}

}  // namespace feedscope
