// The part of HeidenhainReader for cycle definitions and calls.
#include <fmt/format.h>

#include <array>

#include "core/base/units.h"
#include "core/program/heidenhain/heidenhain_reader.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

namespace {

/// Behind the name of a value, "DIST 2", "V.ZEIT0.5".
void skip_value_name(Scanner& scanner) {
  while (!scanner.at_end()) {
    const char c = scanner.peek();
    const char next = scanner.peek_at(1);
    if (letters::is_digit(c) || c == '+' || c == '-' || (c == '.' && letters::is_digit(next)) ||
        (letters::to_upper(c) == 'Q' &&
         (letters::is_digit(next) || letters::to_upper(next) == 'L' || letters::to_upper(next) == 'R'))) {
      return;
    }
    scanner.move_to(scanner.at() + 1);
  }
}

std::string_view title_of(std::string_view text) {
  const std::size_t parameter = text.find('=');
  std::string_view title = text.substr(0, parameter);
  if (parameter != std::string_view::npos) {
    title = title.substr(0, title.find_last_of("Qq"));
  }
  const std::size_t first = title.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : title.substr(first, title.find_last_not_of(' ') + 1 - first);
}

}  // namespace

void HeidenhainReader::cycle(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("CALL")) {
    cycle_call(scanner, column);
    return;
  }
  if (!scanner.take_keyword("DEF")) {
    report_unknown(scanner.text(), column);
    return;
  }
  const auto digits = [&] {
    int value = 0;
    for (scanner.peek(); letters::is_digit(scanner.peek_at(0)); scanner.move_to(scanner.at() + 1)) {
      value = std::min(value * 10 + (scanner.peek_at(0) - '0'), 9999);
    }
    return value;
  };
  const int number = digits();
  if (scanner.take('.')) {
    old_cycle_line(number, digits(), scanner, column);
  } else {
    define_cycle(number, title_of(scanner.rest()), scanner, column);
  }
}

void HeidenhainReader::cycle_call(Scanner& scanner, std::uint32_t column) {
  if (scanner.take_keyword("PAT")) {
    call_cycle_at_pattern(words(scanner), column);
  } else if (scanner.take_keyword("POS")) {
    call_cycle_at(words(scanner), column);
  } else {
    run_functions(words(scanner));
    call_cycle(column);
  }
}

void HeidenhainReader::old_cycle_line(int number, int part, Scanner& scanner, std::uint32_t column) {
  constexpr int spindle_orientation = 13;
  switch (number) {
    case 1:
    case 2:
    case 17:
      if (part == 0) {
        define_old_drilling(number);
      } else {
        skip_value_name(scanner);
        set_old_drilling(number, part, formulas().read_value(scanner));
      }
      return;
    case spindle_orientation:
      return;
    case 7:
    case 8:
    case 10:
    case 11:
    case 26:
      if (part > 0) {
        transformation_cycle(number, scanner, column);
        apply_transformations(column);
      }
      return;
    case 9:
      if (part > 0) {
        skip_value_name(scanner);
        dwell(formulas().read_value(scanner), column);
      }
      return;
    case 12:
      if (part > 0) {
        scanner.take_keyword("PGM");
        define_program_cycle(scanner.rest());
      }
      return;
    case 19:
      if (part > 0) {
        tilt_cycle(scanner, column);
      }
      return;
    case 32:
      tolerance(part, scanner, column);
      return;
    default:
      if (part == 0) {
        leave_out_cycle(number, title_of(scanner.rest()), column);
      }
      return;
  }
}

void HeidenhainReader::transformation_cycle(int number, Scanner& scanner, std::uint32_t column) {
  switch (number) {
    case 7:
      return datum_shift(scanner, column);
    case 8:
      return mirror(scanner, column);
    case 10:
      return rotation(scanner, column);
    case 11:
      return scaling(scanner, column);
    default:
      return axis_scaling(scanner);
  }
}

void HeidenhainReader::datum_shift(Scanner& scanner, std::uint32_t column) {
  if (scanner.take('#') || scanner.take_keyword("TABLE")) {
    // The line of the table, taken as zero, takes the place of the shift in force.
    transformations().reset(Transformations::Kind::shift);
    set_datum("a line of the datum table", column);
    return;
  }
  shift_datum(words(scanner).axes, column);
}

void HeidenhainReader::mirror(Scanner& scanner, std::uint32_t) {
  std::array<bool, 3> axes{};
  while (!scanner.at_end()) {
    axes[static_cast<std::size_t>(axis_letter(scanner))] = true;
  }
  transformations().mirror(axes);
}

int HeidenhainReader::axis_letter(Scanner& scanner) {
  const char letter = letters::to_upper(scanner.peek());
  if (letter < 'X' || letter > 'Z') {
    throw ReadFault{"unread-word", scanner.column(),
                    fmt::format("{} is not X, Y or Z", quoted(scanner.rest())),
                    "the transformation is left out"};
  }
  scanner.take(letter);
  return letter - 'X';
}

void HeidenhainReader::rotation(Scanner& scanner, std::uint32_t) {
  const bool incremental = scanner.take("IROT");
  if (!incremental) {
    scanner.take("ROT");
  }
  transformations().rotate(plane(), units::from_deg(formulas().read_value(scanner)), incremental);
}

double HeidenhainReader::factor(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  return checked_factor(formulas().read_value(scanner), column);
}

void HeidenhainReader::scaling(Scanner& scanner, std::uint32_t) {
  scanner.take("SCL");
  transformations().scale(Vec3::Constant(factor(scanner)));
}

void HeidenhainReader::axis_scaling(Scanner& scanner) {
  Vec3 factors = Vec3::Ones();
  Vec3 center = Vec3::Zero();
  while (!scanner.at_end()) {
    const bool is_center = scanner.take("CC");
    const int axis = axis_letter(scanner);
    if (is_center) {
      center[axis] = to_mm(formulas().read_value(scanner));
    } else {
      factors[axis] = factor(scanner);
    }
  }
  transformations().scale(factors, center);
}

void HeidenhainReader::tolerance(int part, Scanner& scanner, std::uint32_t column) {
  const PathControl& control = path().path_control();
  if (part == 1) {
    std::optional<double> tolerance;
    if (scanner.take('T') && !scanner.at_end()) {
      tolerance = to_mm(formulas().read_value(scanner));
    }
    set_tolerance(tolerance, std::nullopt, column);
  } else if (part == 2) {
    if (scanner.take("HSC-MODE:")) {
      formulas().read_value(scanner);
    }
    if (scanner.take("TA")) {
      set_tolerance(control.contour_tolerance, units::from_deg(formulas().read_value(scanner)), column);
    }
  }
}

}  // namespace feedscope
