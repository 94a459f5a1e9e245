// The part of HeidenhainIsoReader for G codes that are no motions.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_iso_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

constexpr auto quiet_codes = std::to_array<int>({0,  1,  2,  3,  5,  6,  7,  10, 11, 12, 13, 15, 16, 17, 18,
                                                 19, 20, 36, 38, 40, 41, 42, 50, 51, 70, 71, 90, 91, 98});
constexpr auto milling_cycles = std::to_array<int>({37, 56, 57, 58, 59, 74, 75, 76, 77, 78, 80, 86});

template <std::size_t Count>
bool is_one_of(int code, const std::array<int, Count>& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

}  // namespace

bool HeidenhainIsoReader::run_codes(const Block& block) {
  bool used = false;
  for (int i = 0; i < block.code_count; ++i) {
    const int code = block.codes[static_cast<std::size_t>(i)];
    const MotionWords& words = block.motion;
    if (is_one_of(code, quiet_codes)) {
      continue;
    }
    used = true;
    switch (code) {
      case 4:
        dwell(words.feed, block.column);
        break;
      case 29:
        set_pole({});
        break;
      case 30:
      case 31:
        set_blank_corner(code == 31, words.axes, block.column);
        break;
      case 62:
        set_tolerance(block.values[0] ? std::optional(to_mm(*block.values[0])) : std::nullopt,
                      block.values[2] ? std::optional(units::from_deg(*block.values[2])) : std::nullopt,
                      block.column);
        break;
      case 79:
        run_functions(with_modal_rapid(words));
        call_cycle(block.column);
        break;
      case 83:
      case 84:
      case 85:
        run_old_cycle(code == 83 ? 1 : code == 84 ? 2 : 17, block);
        break;
      case 99:
        if (block.tool.tool && block.radius) {
          define_tool(*block.tool.tool, to_mm(*block.radius));
        }
        break;
      default:
        if (!run_transformation(code, block) && !run_corner_code(code, block)) {
          report_code(code, block.code_column);
        }
        break;
    }
  }
  return used;
}

void HeidenhainIsoReader::run_old_cycle(int number, const Block& block) {
  define_old_drilling(number);
  for (std::size_t part = 1; part < block.values.size(); ++part) {
    if (block.values[part]) {
      set_old_drilling(number, static_cast<int>(part), *block.values[part]);
    }
  }
}

bool HeidenhainIsoReader::run_transformation(int code, const Block& block) {
  const MotionWords& words = block.motion;
  switch (code) {
    case 28:
      transformations().mirror({words.axes[0].given, words.axes[1].given, words.axes[2].given});
      break;
    case 53:
      set_datum("a line of the datum table", block.column);
      return true;
    case 54:
      shift_datum(words.axes, block.column);
      break;
    case 72:
      transformations().scale(Vec3::Constant(checked_factor(words.feed, block.column)));
      break;
    case 73:
      transformations().rotate(plane(), units::from_deg(block.angle.value_or(0)), words.axes[0].incremental);
      break;
    default:
      return false;
  }
  apply_transformations(block.column);
  return true;
}

bool HeidenhainIsoReader::run_corner_code(int code, const Block& block) {
  if (code < 24 || code > 27) {
    return false;
  }
  if (!block.radius) {
    throw ReadFault{"corner", block.column, fmt::format("G{} without R", code), "it is left out"};
  }
  const double size = to_mm(*block.radius);
  if (code == 24 || code == 25) {
    run_corner(code == 25, size, block.motion, block.column);
  } else if (code == 26) {
    run_soft_approach(size, block.motion, block.column);
  } else {
    leaving_radius_ = size;
    leaving_feed_ = feed_alone(block.motion);
  }
  return true;
}

void HeidenhainIsoReader::report_code(int code, std::uint32_t column) {
  constexpr int first_long_cycle = 100;
  if (is_one_of(code, milling_cycles) || code >= first_long_cycle) {
    leave_out_cycle(code, "", column);
    return;
  }
  report(Severity::error, "unknown-g", code, column, [&] {
    return Text{fmt::format("G{} is not read in this dialect", code),
                "the block is left out; the path may differ from what the control does"};
  });
}

}  // namespace feedscope
