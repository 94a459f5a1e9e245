#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/program/sinumerik/language/functions.h"

namespace feedscope::sinumerik {

/// Meaning of a coordinate.
enum class Reading : std::uint8_t {
  modal,        ///< by G90 or G91
  absolute,     ///< AC()
  incremental,  ///< IC()
  shortest,     ///< DC()
  positive,     ///< ACP(): absolute, in the positive direction
  negative,     ///< ACN()
};

/// Meaning of a coordinate across the turning axis.
enum class Across : std::uint8_t {
  modal,     ///< by DIAMON, DIAM90, DIAMOF
  diameter,  ///< DAC(), DIC()
  radius,    ///< RAC(), RIC()
};

/// Addresses of more than one letter that take a value.
enum class Address : std::uint8_t {
  cr,    ///< radius
  ar,    ///< opening angle [deg]
  turn,  ///< further full circles
  i1,    ///< point on the way of CIP
  j1,
  k1,
  ap,    ///< polar angle [deg]
  rp,    ///< polar radius
  ang,   ///< angle of a line [deg]
  rpl,   ///< rotation in the plane [deg]
  pw,    ///< weight of a B-spline's point
  pl,    ///< parameter interval of a spline's or polynomial's block
  sd,    ///< degree of a B-spline
  fb,    ///< feed of this block
  rnd,   ///< radius at the corner at the end
  rndm,  ///< the same for every corner
  chf,   ///< length of a chamfer at the corner
  chr,   ///< side that a chamfer cuts off both elements
  frc,   ///< feed of the rounding or chamfer
  frcm,  ///< the same for every one
  p,     ///< runs of a call or repeat
};

inline constexpr std::size_t address_count = static_cast<std::size_t>(Address::p) + 1;

/// The words of one block, the last one of each address.
class BlockWords {
 public:
  struct Value {
    double value = 0;
    std::uint32_t column = 0;
    Reading reading = Reading::modal;
    Across across = Across::modal;
  };

  void clear() {
    letters_present_ = 0;
    addresses_present_ = 0;
  }

  bool has(char letter) const { return (letters_present_ >> index(letter) & 1U) != 0; }
  bool has(Address address) const { return (addresses_present_ >> static_cast<unsigned>(address) & 1U) != 0; }
  bool has_any(std::string_view letters) const {
    for (const char letter : letters) {
      if (has(letter)) {
        return true;
      }
    }
    return false;
  }
  /// By angle and radius about the pole.
  bool is_polar() const { return has(Address::ap) || has(Address::rp); }
  const Value& operator[](char letter) const { return letters_[index(letter)]; }
  const Value& operator[](Address address) const { return addresses_[static_cast<std::size_t>(address)]; }

  void set(char letter, const Value& value) {
    letters_[index(letter)] = value;
    letters_present_ |= 1U << index(letter);
  }
  void set(Address address, const Value& value) {
    addresses_[static_cast<std::size_t>(address)] = value;
    addresses_present_ |= 1U << static_cast<unsigned>(address);
  }
  void remove(std::string_view letters) {
    for (const char letter : letters) {
      letters_present_ &= ~(1U << index(letter));
    }
  }

  /// Column of the first of these letters in the block; 0 if there is none.
  std::uint32_t first_column(std::string_view letters) const {
    std::uint32_t column = 0;
    for (const char letter : letters) {
      if (has(letter) && (column == 0 || (*this)[letter].column < column)) {
        column = (*this)[letter].column;
      }
    }
    return column;
  }

 private:
  static std::size_t index(char letter) { return static_cast<std::size_t>(letter - 'A'); }

  std::array<Value, 26> letters_;
  std::array<Value, address_count> addresses_;
  std::uint32_t letters_present_ = 0;
  std::uint32_t addresses_present_ = 0;
};

/// Effects of the functions of one block: G words, names without value, M words.
struct BlockFunctions {
  std::array<const Function*, group_count> groups{};  ///< the block's function of each group
  const Function* own_block = nullptr;                ///< to which the block's coordinates belong
  std::uint32_t own_column = 0;                       ///< of `own_block`
  std::uint32_t compensation_column = 0;              ///< of G40, G41, G42
  const Function* machine_axes = nullptr;             ///< G53, G153, SUPA, G74, G75, G751
  int fixed_point = 1;                                ///< FP of G75
  bool exact_stop = false;                            ///< G9
  bool tool_change = false;                           ///< M6
  bool spindle_start = false;                         ///< M3, M4
  bool spindle_stop = false;                          ///< M5, M19
  bool stop = false;                                  ///< M0, M1
  bool ends = false;                                  ///< M2, M17, M30, RET

  const Function* operator[](Group group) const { return groups[static_cast<std::size_t>(group)]; }
  const Function*& operator[](Group group) { return groups[static_cast<std::size_t>(group)]; }
};

}  // namespace feedscope::sinumerik
