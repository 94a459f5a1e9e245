#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/last_motion.h"
#include "core/program/sinumerik/geometry/spline_path.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Reads PO[X]=(end, a2, a3, ...) and moves along the polynomials of a block with POLY.
class Polynomials : private Part {
 public:
  /// All outlive it.
  Polynomials(Context& context, Values& values, LastMotion& last)
      : Part(context), values_(values), last_(last) {}

  /// Forgets those of the previous block.
  void begin_block();
  /// Reads the value of `name`, which has just been read, if it is PO; else returns false. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner);
  /// Moves along the polynomials of the block to `target`, programmed coordinates [mm]. Returns the start of
  /// a line with the curve's end and end direction.
  Vec3 move(const Vec3& target);

 private:
  void read(Scanner& scanner);

  Values& values_;
  LastMotion& last_;
  std::array<std::optional<PolynomialWord>, 3> words_by_axis_;
  bool has_words_ = false;
};

}  // namespace feedscope::sinumerik
