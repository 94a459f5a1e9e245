#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/base/message.h"

namespace feedscope {

enum class LengthUnit : std::uint8_t { mm, inch };

/// "mm", "inch".
std::string_view to_string(LengthUnit unit);

/// Unit of a program's first motion, and its source.
struct ProgramUnit {
  enum class Source : std::uint8_t {
    assumed,  ///< not given: mm is used
    asked,    ///< ReadOptions
    program,  ///< the program itself: G20, G71, BEGIN PGM n MM
  };
  LengthUnit unit = LengthUnit::mm;
  Source source = Source::assumed;

  bool operator==(const ProgramUnit&) const = default;
};

/// "inch, by the program", "mm, by --unit", "mm, assumed: the program does not define its unit".
Message describe(const ProgramUnit& unit);

/// Sizes of a cut that tell units apart.
struct CutSize {
  Vec3 size = Vec3::Zero();  ///< extents of the ends of its feed motions [mm]
  double feed = 0;           ///< the largest programmed [mm/s]
};

/// True if sizes and feeds are smaller than those of metric programs: numbers of an inch program, read as mm.
bool looks_like_inches(const CutSize& cut);

}  // namespace feedscope
