#include "core/program/sinumerik/geometry/polynomials.h"

#include "core/program/path/curve_lines.h"
#include "core/program/sinumerik/geometry/coordinate_value.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::sinumerik {

void Polynomials::begin_block() {
  if (has_words_) {
    words_by_axis_.fill(std::nullopt);
    has_words_ = false;
  }
}

bool Polynomials::run(std::string_view name, Scanner& scanner) {
  if (!letters::same(name, "PO")) {
    return false;
  }
  read(scanner);
  return true;
}

/// Reads the rest after "PO"; "PO[X]=value" is only an end.
void Polynomials::read(Scanner& scanner) {
  const std::uint32_t column = scanner.column();
  require(scanner, '[');
  const std::string_view axis = scanner.name();
  const char letter = axis.empty() ? ' ' : letters::to_upper(axis[0]);
  require(scanner, ']');
  require(scanner, '=');
  if (axis.size() != 1 || letter < 'X' || letter > 'Z') {
    report(Severity::error, "polynomial", 0, column, [&] {
      return Text{axis.empty()
                      ? NC_("core", "a denominator of polynomials is not supported")
                      : message(NC_("core", "a polynomial of axis {} is not supported"), in_quotes(axis)),
                  NC_("core", "X, Y and Z are shown without it")};
    });
    if (scanner.peek() == '(') {
      skip_brackets(scanner);
    } else {
      values_.read(scanner);
    }
    return;
  }
  const bool list = scanner.take('(');
  PolynomialWord word;
  words_.set(letter, read_coordinate(values_, scanner, column));
  for (std::size_t i = 0; list && scanner.take(','); ++i) {
    if (i >= word.coefficients.size()) {
      throw ReadFault{"polynomial", scanner.column(),
                      NC_("core", "a polynomial has more than 5 coefficients"),
                      NC_("core", "the block does not move; write a polynomial of degree 5 or less")};
    }
    word.coefficients[i] = to_mm(values_.read_bounded(scanner));
  }
  if (list) {
    require(scanner, ')');
  }
  words_by_axis_[static_cast<std::size_t>(letter - 'X')] = word;
  has_words_ = true;
}

Vec3 Polynomials::move(const Vec3& target) {
  last_.set_line();
  const Vec3 start = path().position();
  const double interval = words_.has(Address::pl) ? words_[Address::pl].value : 1;
  if (!has_words_ || !(interval > 0)) {
    path().line(target);
    return start;
  }
  const auto curve = [&](double parameter) -> CurvePlace {
    CurvePlace place{start + (target - start) * parameter / interval, (target - start) / interval};
    for (std::size_t i = 0; i < 3; ++i) {
      if (words_by_axis_[i]) {
        const int axis = static_cast<int>(i);
        PolynomialWord word = *words_by_axis_[i];
        word.end = target[axis];
        place.point[axis] = word.at(parameter, start[axis], interval);
        place.slope[axis] = word.slope_at(parameter, start[axis], interval);
      }
    }
    return place;
  };
  const Vec3 direction = path().curve(curve, 0, interval, words_.first_column("XYZ"));
  return path().position() - direction;
}

}  // namespace feedscope::sinumerik
