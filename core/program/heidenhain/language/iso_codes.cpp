#include "core/program/heidenhain/language/iso_codes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

constexpr auto quiet_codes = std::to_array<int>({0,  1,  2,  3,  5,  6,  7,  10, 11, 12, 13, 15, 16, 17, 18,
                                                 19, 20, 36, 38, 40, 41, 42, 50, 51, 70, 71, 90, 91, 98});
constexpr auto milling_cycles = std::to_array<int>({37, 56, 57, 58, 59, 74, 75, 76, 77, 78, 80, 86});

template <std::size_t Count>
bool is_one_of(int code, const std::array<int, Count>& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

void IsoCodes::apply_modes(IsoBlock& block) {
  for (int i = 0; i < block.code_count; ++i) {
    const int code = block.codes[static_cast<std::size_t>(i)];
    if (code == 90 || code == 91) {
      motions_.set_incremental(code == 91);
    } else if (code == 70 || code == 71) {
      parts_.context.set_inch(code == 70);
    } else if (code >= 40 && code <= 42) {
      block.motion.side = code == 40 ? SideWord::off : code == 41 ? SideWord::left : SideWord::right;
      block.motion.side_column = block.code_column;
    } else {
      motions_.set_motion(code);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.motion.axes[axis].incremental = motions_.is_incremental();
    block.pole[axis].incremental = motions_.is_incremental();
  }
}

bool IsoCodes::run(const IsoBlock& block) {
  bool used = false;
  for (int i = 0; i < block.code_count; ++i) {
    const int code = block.codes[static_cast<std::size_t>(i)];
    if (!is_one_of(code, quiet_codes)) {
      used = true;
      run_code(code, block);
    }
  }
  return used;
}

void IsoCodes::run_code(int code, const IsoBlock& block) {
  const MotionWords& words = block.motion;
  switch (code) {
    case 4:
      parts_.dwells.run(words.feed, block.column);
      break;
    case 29:
      parts_.targets.set_pole({});
      break;
    case 30:
    case 31:
      parts_.blank.set_corner(code == 31, words.axes, block.column);
      break;
    case 62:
      parts_.path_modes.set_tolerance(
          block.values[0] ? std::optional(to_mm(*block.values[0])) : std::nullopt,
          block.values[2] ? std::optional(units::from_deg(*block.values[2])) : std::nullopt, block.column);
      break;
    case 79:
      parts_.cycle_calls.call(motions_.with_modal_rapid(words), block.column);
      break;
    case 83:
    case 84:
    case 85:
      run_old_cycle(code == 83 ? 1 : code == 84 ? 2 : 17, block);
      break;
    case 99:
      if (block.tool.tool && block.radius) {
        parts_.tools.define(*block.tool.tool, to_mm(*block.radius));
      }
      break;
    default:
      if (!run_transformation(code, block) && !run_corner(code, block)) {
        report_unsupported(code, block.code_column);
      }
      break;
  }
}

void IsoCodes::run_old_cycle(int number, const IsoBlock& block) {
  parts_.cycles.define_old_drilling(number);
  for (std::size_t part = 1; part < block.values.size(); ++part) {
    if (block.values[part]) {
      parts_.cycles.set_old_drilling(number, static_cast<int>(part), *block.values[part]);
    }
  }
}

bool IsoCodes::run_transformation(int code, const IsoBlock& block) {
  const MotionWords& words = block.motion;
  switch (code) {
    case 28:
      parts_.coordinates.transformations().mirror(
          {words.axes[0].given, words.axes[1].given, words.axes[2].given});
      break;
    case 53:
      parts_.coordinates.set_datum(NC_("core", "a line of the datum table"), block.column);
      return true;
    case 54:
      parts_.coordinates.shift_datum(words.axes, block.column);
      break;
    case 72:
      parts_.coordinates.transformations().scale(Vec3::Constant(checked_factor(words.feed, block.column)));
      break;
    case 73:
      parts_.coordinates.transformations().rotate(plane(), units::from_deg(block.angle.value_or(0)),
                                                  words.axes[0].incremental);
      break;
    default:
      return false;
  }
  parts_.coordinates.apply(block.column);
  return true;
}

bool IsoCodes::run_corner(int code, const IsoBlock& block) {
  if (code < 24 || code > 27) {
    return false;
  }
  if (!block.radius) {
    throw ReadFault{"corner", block.column, message(NC_("core", "G{} without R"), code),
                    NC_("core", "it is skipped; write R")};
  }
  const double size = to_mm(*block.radius);
  if (code == 24 || code == 25) {
    parts_.motions.run_corner(code == 25, size, block.motion, block.column);
  } else if (code == 26) {
    parts_.approaches.soften(size, block.motion, block.column);
  } else {
    motions_.leave_by(size, parts_.feeds.alone(block.motion));
  }
  return true;
}

void IsoCodes::report_unsupported(int code, std::uint32_t column) {
  constexpr int first_long_cycle = 100;
  if (is_one_of(code, milling_cycles) || code >= first_long_cycle) {
    parts_.cycles.skip(code, "", column);
    return;
  }
  report(Severity::error, "unknown-g", code, column, [&] {
    return Text{message(NC_("core", "G{} is not supported in this dialect"), code),
                NC_("core", "the block is skipped; the control may run another path")};
  });
}

}  // namespace feedscope::heidenhain
