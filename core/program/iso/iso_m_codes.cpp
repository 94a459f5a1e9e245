// The part of IsoReader that reads M words, tools, and lines that are no blocks.
#include <fmt/format.h>

#include <cmath>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

void IsoReader::apply_m(const Word& word) {
  words_.other_codes = true;
  if (word.value != std::floor(word.value) || word.value < 0 || word.value > 1000) {
    return;
  }
  const bool linuxcnc = follows_linuxcnc(dialect_);
  switch (static_cast<int>(word.value)) {
    case 0:
    case 1:
    case 60:
      words_.stop = true;
      break;
    case 2:
    case 30:
      end_program();
      break;
    case 3:
    case 4:
    case 13:
    case 14:
      start_spindle();
      break;
    case 5:
    case 19:
      stop_spindle();
      break;
    case 6:
      state_.tool = words_.has('T') ? words_['T'].value : state_.selected_tool;
      change_tool(fmt::format("{}", state_.tool));
      break;
    case 70:
    case 71:
    case 72:
    case 73:
      if (linuxcnc) {
        keep_modal_state(word);
      }
      break;
    case 97:
      // Without P it ends the macro interrupts of a Fanuc.
      words_.flow = words_.has('P') ? &word : words_.flow;
      break;
    case 98:
    case 99:
      words_.flow = &word;
      break;
    case 117:
    case 118:
      // The words are a text for the operator of a printer.
      words_.own_words = words_.own_words || dialect_ == Dialect::grbl;
      break;
    case 198:
      words_.flow = linuxcnc ? words_.flow : &word;
      break;
    default:
      break;
  }
}

void IsoReader::keep_modal_state(const Word& word) {
  std::optional<KeptState>& kept = frames_.back().kept;
  const int code = static_cast<int>(word.value);
  switch (code) {
    case 70:
    case 73:
      kept = KeptState{state_, path().feed_mode(), path().feed(), path().path_control(), code == 73};
      break;
    case 71:
      kept.reset();
      break;
    default:
      if (kept) {
        restore(*kept);
      } else {
        report(Severity::error, "modal-state", 0, word.column, [] {
          return Text{"M72 has no modal state to restore", "nothing changes; write M70 before it"};
        });
      }
      break;
  }
}

void IsoReader::restore(const KeptState& kept) {
  state_.plane = kept.state.plane;
  state_.inch = kept.state.inch;
  state_.incremental = kept.state.incremental;
  state_.absolute_centers = kept.state.absolute_centers;
  state_.to_initial_level = kept.state.to_initial_level;
  if (kept.state.work_offset != 0 && kept.state.work_offset != state_.work_offset) {
    state_.work_offset = kept.state.work_offset;
    coordinates_.select_work_offset(state_.work_offset);
    path().use_work_offset(offset_name(state_.work_offset), coordinates_.zero_of(state_.work_offset));
    set_frame();
  }
  path().set_feed_mode(kept.feed_mode);
  if (kept.feed > 0) {
    path().set_feed(kept.feed);
  }
  path().set_path_control(kept.path_control);
}

void IsoReader::ask_for_tool(double number) {
  if (number > 0 && number != state_.selected_tool) {
    select_tool(fmt::format("{}", number));
  }
  state_.selected_tool = number;
}

bool IsoReader::begins_next_program(const Block& block) {
  if (block.words.empty() || block.words.front().letter != 'O') {
    return false;
  }
  std::uint32_t& start = frames_.back().program;
  const bool is_start = start == line() || (start == 0 && (call_depth() > 0 || !words_met_));
  if (is_start) {
    start = line();
    return false;
  }
  if (call_depth() > 0) {
    leave_call();
  } else {
    end_program();
  }
  return true;
}

bool IsoReader::is_grbl_command(const Block& block) {
  constexpr std::string_view commands = "$?!~";
  const bool command = block.words.empty() && !block.faults.empty() &&
                       commands.find(block.text_of(block.faults.front())) != std::string_view::npos;
  if (command) {
    report(Severity::info, "control-command", 0, block.faults.front().column, [&] {
      return Text{fmt::format("{} is a command to the control", quoted(block.text)),
                  "it does not change the path"};
    });
  }
  return command;
}

}  // namespace feedscope
