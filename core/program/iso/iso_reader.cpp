#include "core/program/iso/iso_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/units.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

/// Ten times a G number; -1 for what cannot be one.
int g_number(double value) {
  const double tenfold = std::round(value * 10);
  return value >= 0 && tenfold < 100000 && std::abs(tenfold - value * 10) < 1e-6 ? static_cast<int>(tenfold)
                                                                                 : -1;
}

}  // namespace

IsoReader::IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress,
                     bool absolute_centers)
    : Reader(std::move(source), options, progress),
      dialect_(options.dialect.value_or(Dialect::iso)),
      variables_(dialect_),
      expression_(dialect_, *this) {
  state_.absolute_centers = absolute_centers;
  state_.inch = first_unit() == LengthUnit::inch;
  argument_lexer_.take_e_as_word();
  take_given_offsets();
}

/// The arguments of a macro call may hold E behind a number, "K1.E5.".
bool IsoReader::calls_macro(const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const Word& word) {
    return word.letter == 'G' && (word.value == 65 || word.value == 66);
  });
}

bool IsoReader::doubts_centers() const {
  // A single wrong centre may fit as a position by chance.
  constexpr std::uint64_t fewest = 3;
  const PathWriter::CenterCount& centers = path().centers();
  const bool has_parameter = !follows_linuxcnc(dialect_);
  return has_parameter && !centers_named_ && centers.misfits >= fewest && 2 * centers.misfits > centers.arcs;
}

void IsoReader::Words::clear() {
  present = 0;
  groups.fill(nullptr);
  other_codes = false;
  own_words = false;
  exact_stop = false;
  stop = false;
  dwell = 0;
  macro_call = false;
  distance = nullptr;
  angle = nullptr;
  corner = nullptr;
  flow = nullptr;
  function_count = 0;
}

std::uint32_t IsoReader::Words::first_column(Letters letters) const {
  std::uint32_t column = 0;
  for (std::uint32_t left = present & letters.mask; left != 0; left &= left - 1) {
    const std::uint32_t at = by_letter[static_cast<std::size_t>(std::countr_zero(left))].column;
    column = column == 0 ? at : std::min(column, at);
  }
  return column;
}

void IsoReader::run_line(std::string_view line) {
  const Block& as_words = lexer_.read(line);
  const Block& block =
      !as_words.faults.empty() && calls_macro(as_words) ? argument_lexer_.read(line) : as_words;
  const bool skipped = options().skip_deleted_blocks && block.delete_level > 0;
  const std::size_t depth = call_depth();
  bool percent = block.percent > 0;
  if (!skipped && block.statement > 0) {
    count_block();
    percent = run_statement(block);
  } else if (!skipped && !(block.words.empty() && block.faults.empty())) {
    count_block();
    if (!is_no_block(block)) {
      run_block(block, true);
    }
  }
  if (percent && words_met_ && call_depth() == depth) {
    depth > 0 ? leave_call() : end_program();
  }
}

void IsoReader::run_block(const Block& block, bool readable) {
  words_met_ = words_met_ || !block.words.empty();
  report_faults(block);
  gather(block);
  const bool sound =
      readable && std::all_of(block.faults.begin(), block.faults.end(),
                              [](const Fault& fault) { return fault.kind == FaultKind::unclosed_comment; });
  if (words_.macro_call) {
    if (sound) {
      gather_macro_call(block);
    }
    return;
  }
  apply_feed();
  if (sound) {
    run_functions();
    check_rotary();
    check_unused();
    words_.exact_stop ? move_to_exact_stop() : move();
  }
  if (words_.stop) {
    stop_program();
  }
  run_calls(sound);
}

std::uint32_t IsoReader::first_word(std::string_view line) {
  const Block& block = lexer_.read(line);
  return block.words.empty() ? block.statement : block.words.front().column;
}

void IsoReader::gather(const Block& block) {
  words_.clear();
  bool codes = false;
  for (const Word& word : block.words) {
    if (word.comma) {
      words_.corner = &word;
      continue;
    }
    switch (word.letter) {
      case 'G':
        words_.macro_call |= word.value == 65 || word.value == 66;
        codes = true;
        continue;
      case 'M':
        codes = true;
        continue;
      case '@':
        words_.distance = &word;
        continue;
      case '^':
        words_.angle = &word;
        continue;
      case 'N':
      case 'O':
        continue;
      default:
        break;
    }
    if (words_.has(word.letter) && !words_.macro_call) {
      report(Severity::error, "duplicate-word", 0, word.column, [&] {
        return Text{fmt::format("{} stands twice in the block", word.letter),
                    fmt::format("{} counts; remove the other", quoted(block.text_of(word)))};
      });
    }
    words_.present |= 1U << (word.letter - 'A');
    words_.by_letter[static_cast<std::size_t>(word.letter - 'A')] = word;
  }
  if (codes && !words_.macro_call) {
    for (const Word& word : block.words) {
      if (word.letter == 'G') {
        apply_g(block, word);
      } else if (word.letter == 'M') {
        apply_m(word);
      }
    }
  }
  if (words_.has('T')) {
    ask_for_tool(words_['T'].value);
  }
}

void IsoReader::apply_g(const Block& block, const Word& word) {
  const int number = g_number(word.value);
  const GCode* const code = find_g_code(number);
  if (code == nullptr) {
    words_.other_codes = true;
    report(Severity::error, "unknown-g", number, word.column, [&] {
      return Text{fmt::format("{} is not a known G word", quoted(block.text_of(word))),
                  "it is left out; the path may differ from what the control does"};
    });
    return;
  }
  if (code->group != GGroup::none) {
    const GCode*& present = words_.groups[static_cast<std::size_t>(code->group)];
    if (present != nullptr && present != code) {
      report(Severity::error, "conflicting-g", number, word.column, [&] {
        return Text{
            fmt::format("{} and {} exclude each other in one block", g_name(present->number), g_name(number)),
            fmt::format("{} counts; remove the other", g_name(number))};
      });
    }
    present = code;
  }
  words_.other_codes = words_.other_codes || code->group != GGroup::motion;
  if (code->needs_axes && !words_.has_any("XYZ")) {
    words_.other_codes = true;
    if (number == 50 || number == 51) {
      apply_path_control(*code);
    }
    return;
  }
  report_unread(*code, word);
  apply_modal(*code, word);
}

void IsoReader::apply_modal(const GCode& code, const Word& word) {
  switch (code.action) {
    case GAction::accept:
    case GAction::report:
      break;
    case GAction::rapid:
      state_.motion = MotionMode::rapid;
      break;
    case GAction::line:
      state_.motion = MotionMode::line;
      break;
    case GAction::arc_cw:
      state_.motion = MotionMode::arc_cw;
      break;
    case GAction::arc_ccw:
      state_.motion = MotionMode::arc_ccw;
      break;
    case GAction::dwell:
      words_.dwell = word.column;
      break;
    case GAction::plane_xy:
      state_.plane = Plane::xy;
      break;
    case GAction::plane_zx:
      state_.plane = Plane::zx;
      break;
    case GAction::plane_yz:
      state_.plane = Plane::yz;
      break;
    case GAction::inch:
    case GAction::metric:
      state_.inch = code.action == GAction::inch;
      say_unit(state_.inch ? LengthUnit::inch : LengthUnit::mm);
      break;
    case GAction::absolute:
      state_.incremental = false;
      break;
    case GAction::incremental:
      state_.incremental = true;
      break;
    case GAction::absolute_centers:
    case GAction::incremental_centers:
      state_.absolute_centers = code.action == GAction::absolute_centers;
      centers_named_ = true;
      break;
    case GAction::feed_per_minute:
      path().set_feed_mode(FeedMode::per_minute);
      break;
    case GAction::other_feed:
      path().set_feed_mode(code.number == 930 ? FeedMode::inverse_time : FeedMode::per_revolution);
      break;
    case GAction::path_control:
      apply_path_control(code);
      break;
    case GAction::cancel_macro:
      modal_macro_.reset();
      break;
    case GAction::axis_function:
      words_.own_words = true;
      add_function(code.number, word.column);
      break;
    case GAction::function:
      add_function(code.number, word.column);
      break;
    case GAction::cycle:
      begin_cycle(code, word);
      break;
    case GAction::spline:
      begin_spline(code, word);
      break;
    case GAction::cancel_cycle: {
      if (state_.motion == MotionMode::cycle && !follows_linuxcnc(dialect_)) {
        state_.motion = state_.before_cycle;
      } else if (state_.motion == MotionMode::cycle || state_.motion == MotionMode::unread) {
        state_.motion = MotionMode::none;
      }
      break;
    }
    case GAction::own_words:
      words_.own_words = true;
      break;
    case GAction::unread_motion:
      words_.other_codes = true;
      state_.motion = MotionMode::unread;
      break;
  }
}

void IsoReader::apply_feed() {
  if (words_.has('S') && words_['S'].value >= 0) {
    path().set_spindle_speed(words_['S'].value / 60);
  }
  const bool is_time = words_.dwell > 0 && !words_.has_any("PXU");
  if (!words_.has('F') || is_time) {
    return;
  }
  const Word& word = words_['F'];
  if (!(word.value > 0)) {
    report(Severity::error, "feed-value", 0, word.column, [&] {
      return Text{fmt::format("feed F{} is not above zero", word.value),
                  path().feed() > 0 ? "the last valid feed stays in force; write a feed above zero"
                                    : "feed moves run as fast as the axes allow; write a feed above zero"};
    });
    return;
  }
  switch (path().feed_mode()) {
    case FeedMode::per_minute:
      path().set_feed(units::from_mm_min(state_.to_mm(word.value)));
      break;
    case FeedMode::inverse_time:
      path().set_feed(word.value / 60);
      break;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      path().set_feed(state_.to_mm(word.value));
      break;
  }
}

}  // namespace feedscope
