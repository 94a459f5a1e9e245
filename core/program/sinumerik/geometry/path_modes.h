#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/program/sinumerik/context.h"
#include "core/program/sinumerik/geometry/path_words.h"
#include "core/program/sinumerik/language/values.h"

namespace feedscope::sinumerik {

/// Gives motions the program's path control: G60, G64x, ADIS, CTOL, COMPCAD, SOFT, CYCLE832 and similar.
class PathModes : private Part {
 public:
  /// Both outlive it.
  PathModes(Context& context, Values& values) : Part(context), values_(values) {}

  /// Applies a function with Action::path_control, by its name.
  void apply(std::string_view name);
  /// Reads "ADIS=1" after its name: ADIS, ADISPOS, CTOL, OTOL. False, with nothing taken, for other names.
  /// Throws ReadFault.
  bool run(Scanner& scanner, std::string_view name, std::uint32_t column);
  /// CYCLE832: tolerance [mm], code, orientation tolerance [rad]; `column` for messages.
  void set_cycle(double tolerance, int code, std::optional<double> orientation, std::uint32_t column);
  /// Gives the next motion the path control in force.
  void use(bool rapid);

  const PathWords& words() const { return path_words_; }
  void restore(const PathWords& words);

 private:
  enum class Applied : std::uint8_t { none, feed, rapid };

  /// Least tolerance or distance [mm] instead of a smaller one, with a warning about `words`.
  double simulated(double tolerance, const Message& words, std::uint32_t column) const;

  Values& values_;
  PathWords path_words_;
  Applied applied_ = Applied::none;  ///< last state set in the PathWriter
};

}  // namespace feedscope::sinumerik
