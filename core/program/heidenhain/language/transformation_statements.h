#pragma once

#include <cstdint>
#include <string_view>

#include "core/program/heidenhain/geometry/coordinates.h"
#include "core/program/heidenhain/language/words.h"

namespace feedscope::heidenhain {

/// Datum shift, mirroring, rotation and scaling, as TRANS statements and as cycles 7, 8, 10, 11 and 26.
class TransformationStatements : private Part {
 public:
  /// All outlive it.
  TransformationStatements(Context& context, Words& words, Coordinates& coordinates)
      : Part(context), words_(words), coordinates_(coordinates) {}

  /// Reads from after "TRANS". Throws ReadFault.
  void run(Scanner& scanner, std::uint32_t column);
  /// Returns false for any other cycle.
  static bool has_cycle(int number);
  /// Runs a line of such a cycle. Throws ReadFault.
  void run_cycle(int number, Scanner& scanner, std::uint32_t column);

 private:
  void shift(Scanner& scanner, std::uint32_t column);
  void mirror(Scanner& scanner);
  void rotate(Scanner& scanner);
  void scale(Scanner& scanner);
  void scale_axes(Scanner& scanner);
  double factor(Scanner& scanner) const;

  Words& words_;
  Coordinates& coordinates_;
};

}  // namespace feedscope::heidenhain
