#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/program/heidenhain/language/labels.h"
#include "core/program/text/subprogram_files.h"

namespace feedscope::heidenhain {

/// Jumps to labels, calls of labels and programs, repeats, and the ends of programs.
class Calls : private Part {
 public:
  /// All outlive it.
  Calls(Context& context, Labels& labels, SubprogramFiles& files)
      : Part(context), labels_(labels), files_(files) {}

  void call_label(const std::string& label, std::uint32_t column);
  void repeat_from_label(const std::string& label, double times, std::uint32_t column);
  void jump_to_label(const std::string& label, std::uint32_t column);
  /// LBL 0.
  void end_subprogram();
  void call_program(std::string_view written, std::uint32_t column);
  /// The called program returns, the main one ends.
  void end_of_program();
  /// Ends the whole run: the program stops itself.
  void stop_all();

 private:
  struct Frame {
    bool program = false;  ///< a program was called, not a label
    double unit = 1;
    QParameters::Locals locals;
  };

  bool enter(const std::shared_ptr<const SourceText>& text, std::uint32_t line, bool program);
  void leave();

  Labels& labels_;
  SubprogramFiles& files_;
  std::vector<Frame> frames_;
  /// Passes left, by depth of calls, text and line.
  std::map<std::tuple<std::size_t, const SourceText*, std::uint32_t>, double> repeats_left_;
};

}  // namespace feedscope::heidenhain
