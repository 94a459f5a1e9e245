#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/program/dialect.h"

namespace feedscope::iso {

/// Variables set by a program, with the local ones of each call: #1 to #30 and named ones in LinuxCNC, #1 to
/// #33 in Fanuc's macro B. Unset ones have the null value.
class Variables {
 public:
  static constexpr std::size_t max_locals = 33;
  /// By number, [0] unused.
  using Locals = std::array<double, max_locals + 1>;

  explicit Variables(Dialect dialect);

  /// All null; in LinuxCNC all zero, because a missing argument is zero there.
  Locals no_arguments() const;
  bool is_local(std::uint32_t number) const { return number >= 1 && number <= local_count_; }

  double get(std::uint32_t number) const;
  void set(std::uint32_t number, double value);
  /// Names that begin with "_" are global, others belong to the call. By normal_name().
  std::optional<double> get(const std::string& name) const;
  void set(const std::string& name, double value);

  /// Begins a call with its own local variables; leave() restores the caller's.
  void enter(const Locals& arguments);
  void leave();

 private:
  struct Level {
    Locals locals;
    std::map<std::string, double> named;
  };

  std::uint32_t local_count_;
  double argument_left_out_;
  std::vector<Level> levels_;
  std::unordered_map<std::uint32_t, double> numbered_;
  std::map<std::string, double> named_;
};

}  // namespace feedscope::iso
