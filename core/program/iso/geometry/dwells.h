#pragma once

#include <optional>

#include "core/program/iso/context.h"

namespace feedscope::iso {

/// Runs G4; the unit of its time depends on the dialect.
class Dwells : private Part {
 public:
  explicit Dwells(Context& context) : Part(context) {}

  void run();

 private:
  /// True if the words are those of a printer or plotter, not of grbl.
  bool is_printer();
  void check_seconds(const Word& word, bool milliseconds) const;

  std::optional<bool> is_printer_;  ///< once a dwell has asked
};

}  // namespace feedscope::iso
