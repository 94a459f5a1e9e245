#include "core/program/heidenhain/language/transformation_statements.h"

#include <array>

#include "core/base/units.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

/// Reads the letter of an axis: 0 to 2. Throws ReadFault.
int axis_letter(Scanner& scanner) {
  const char letter = letters::to_upper(scanner.peek());
  if (letter < 'X' || letter > 'Z') {
    throw ReadFault{"unread-word", scanner.column(),
                    message(NC_("core", "{} is not X, Y or Z"), in_quotes(scanner.rest())),
                    NC_("core", "the transformation is ignored")};
  }
  scanner.take(letter);
  return letter - 'X';
}

}  // namespace

void TransformationStatements::run(Scanner& scanner, std::uint32_t column) {
  const std::string_view name = scanner.name();
  const bool resets = Scanner(scanner).take_keyword("RESET");
  using Kind = Transformations::Kind;
  if (letters::same(name, "DATUM")) {
    if (resets) {
      coordinates_.transformations().reset(Kind::shift);
    } else {
      scanner.take_keyword("AXIS");
      shift(scanner, column);
    }
  } else if (letters::same(name, "MIRROR")) {
    if (resets) {
      coordinates_.transformations().reset(Kind::mirror);
    } else {
      scanner.take_keyword("AXIS");
      mirror(scanner);
    }
  } else if (letters::same(name, "ROTATION")) {
    if (resets) {
      coordinates_.transformations().reset(Kind::rotation);
    } else {
      rotate(scanner);
    }
  } else if (letters::same(name, "SCALE")) {
    if (resets) {
      coordinates_.transformations().reset(Kind::scale);
    } else {
      scale(scanner);
    }
  } else {
    throw_unread_words(scanner, Message::as_written("TRANS"));
  }
  coordinates_.apply(column);
}

bool TransformationStatements::has_cycle(int number) {
  return number == 7 || number == 8 || number == 10 || number == 11 || number == 26;
}

void TransformationStatements::run_cycle(int number, Scanner& scanner, std::uint32_t column) {
  switch (number) {
    case 7:
      shift(scanner, column);
      break;
    case 8:
      mirror(scanner);
      break;
    case 10:
      rotate(scanner);
      break;
    case 11:
      scale(scanner);
      break;
    default:
      scale_axes(scanner);
      break;
  }
  coordinates_.apply(column);
}

void TransformationStatements::shift(Scanner& scanner, std::uint32_t column) {
  if (scanner.take('#') || scanner.take_keyword("TABLE")) {
    // The line of the table, taken as zero, replaces the shift in force.
    coordinates_.transformations().reset(Transformations::Kind::shift);
    coordinates_.set_datum(NC_("core", "a line of the datum table"), column);
    return;
  }
  coordinates_.shift_datum(words_.read(scanner).axes, column);
}

void TransformationStatements::mirror(Scanner& scanner) {
  std::array<bool, 3> axes{};
  while (!scanner.at_end()) {
    axes[static_cast<std::size_t>(axis_letter(scanner))] = true;
  }
  coordinates_.transformations().mirror(axes);
}

void TransformationStatements::rotate(Scanner& scanner) {
  const bool incremental = scanner.take("IROT");
  if (!incremental) {
    scanner.take("ROT");
  }
  coordinates_.transformations().rotate(plane(), units::from_deg(read_value(scanner)), incremental);
}

double TransformationStatements::factor(Scanner& scanner) const {
  const std::uint32_t column = scanner.column();
  return checked_factor(read_value(scanner), column);
}

void TransformationStatements::scale(Scanner& scanner) {
  scanner.take("SCL");
  coordinates_.transformations().scale(Vec3::Constant(factor(scanner)));
}

void TransformationStatements::scale_axes(Scanner& scanner) {
  Vec3 factors = Vec3::Ones();
  Vec3 center = Vec3::Zero();
  while (!scanner.at_end()) {
    const bool is_center = scanner.take("CC");
    const int axis = axis_letter(scanner);
    if (is_center) {
      center[axis] = read_length(scanner);
    } else {
      factors[axis] = factor(scanner);
    }
  }
  coordinates_.transformations().scale(factors, center);
}

}  // namespace feedscope::heidenhain
