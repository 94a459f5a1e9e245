#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

#include "core/program/heidenhain/geometry/approaches.h"
#include "core/program/heidenhain/language/words.h"

namespace feedscope::heidenhain {

/// Path blocks: L, CC, C, CR, CT, LP, CP, CTP, RND, CHF, APPR and DEP.
class PathStatements : private Part {
 public:
  /// All outlive it.
  PathStatements(Context& context, Words& words, Targets& targets, Motions& motions, Approaches& approaches)
      : Part(context), words_(words), targets_(targets), motions_(motions), approaches_(approaches) {}

  /// Returns false for any other name. Throws ReadFault.
  bool run(std::string_view name, Scanner& scanner, std::uint32_t column);
  /// Runs a block that has words only.
  void line(Scanner& scanner, std::uint32_t column);

 private:
  void pole(Scanner& scanner, std::uint32_t column);
  void center_arc(Scanner& scanner, std::uint32_t column);
  void radius_arc(Scanner& scanner, std::uint32_t column);
  void tangent_arc(Scanner& scanner, std::uint32_t column);
  void polar_line(Scanner& scanner, std::uint32_t column);
  void polar_arc(Scanner& scanner, std::uint32_t column);
  void polar_tangent_arc(Scanner& scanner, std::uint32_t column);
  void rounding(Scanner& scanner, std::uint32_t column);
  void chamfer(Scanner& scanner, std::uint32_t column);
  void approach(Scanner& scanner, std::uint32_t column);
  void departure(Scanner& scanner, std::uint32_t column);
  void run_curve(PathKind kind, Scanner& scanner, std::uint32_t column);

  Words& words_;
  Targets& targets_;
  Motions& motions_;
  Approaches& approaches_;
};

}  // namespace feedscope::heidenhain
