#pragma once

#include "core/base/units.h"
#include "core/program/path/plane.h"
#include "core/program/sinumerik/language/functions.h"
#include "core/program/sinumerik/language/words.h"

namespace feedscope::sinumerik {

/// Modal state shared by several parts of the reader.
struct ModalState {
  const Function* motion = nullptr;  ///< nullptr: no motion word yet
  Plane plane = Plane::xy;
  bool inch = false;         ///< lengths
  bool inch_feed = false;    ///< feeds
  bool incremental = false;  ///< G91

  double to_mm(double value) const { return inch ? units::from_inch(value) : value; }
  bool is_incremental(const BlockWords::Value& word) const {
    return word.reading == Reading::incremental || (word.reading == Reading::modal && incremental);
  }
  /// True if a motion word other than G0 is in force.
  bool moves_at_feed() const { return motion != nullptr && motion->action != Action::rapid; }
};

}  // namespace feedscope::sinumerik
