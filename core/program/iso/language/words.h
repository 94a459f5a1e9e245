#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/program/iso/language/g_codes.h"
#include "core/program/text/lexer.h"

namespace feedscope::iso {

/// A set of word letters, known when compiled.
struct Letters {
  std::uint32_t mask = 0;

  consteval Letters(std::string_view letters) {
    for (const char letter : letters) {
      mask |= 1U << (letter - 'A');
    }
  }
  consteval Letters(const char* letters) : Letters(std::string_view(letters)) {}
};

inline constexpr std::string_view axis_letters = "XYZ";

/// Words of one block by letter, and the effects of its G and M words beyond modal changes.
struct BlockWords {
  std::array<Word, 26> by_letter;
  std::uint32_t present = 0;                         ///< bit per letter
  std::array<const GCode*, g_group_count> groups{};  ///< the block's code of each group
  bool other_codes = false;                          ///< G or M words to which P, Q, L, R, I ... may belong
  bool own_words = false;                            ///< an unsupported code owns the coordinates
  std::uint32_t dwell = 0;                           ///< column of G4; 0: none
  bool exact_stop = false;                           ///< G9
  bool stop = false;                                 ///< M0, M1, M60
  bool changes_unit = false;                         ///< from inch to mm or back
  bool macro_call = false;                           ///< G65, G66: the words are arguments
  const Word* distance = nullptr;                    ///< "@" of LinuxCNC
  const Word* angle = nullptr;                       ///< "^" of LinuxCNC [deg]
  const Word* corner = nullptr;                      ///< ",R" or ",C" of Fanuc
  const Word* flow = nullptr;                        ///< M97, M98 or M99
  struct Function {
    int code = 0;  ///< ten times the G number
    std::uint32_t column = 0;
  };
  std::array<Function, 8> functions{};  ///< in written order
  std::size_t function_count = 0;

  void clear();
  void set(const Word& word) {
    present |= 1U << (word.letter - 'A');
    by_letter[static_cast<std::size_t>(word.letter - 'A')] = word;
  }
  bool has(char letter) const { return (present >> (letter - 'A') & 1U) != 0; }
  bool has_any(Letters letters) const { return (present & letters.mask) != 0; }
  bool has_polar() const { return distance != nullptr || angle != nullptr; }
  bool has(GGroup group) const { return groups[static_cast<std::size_t>(group)] != nullptr; }
  const Word& operator[](char letter) const { return by_letter[static_cast<std::size_t>(letter - 'A')]; }
  /// Value of a word that may be missing.
  double value_or(char letter, double otherwise) const {
    return has(letter) ? (*this)[letter].value : otherwise;
  }
  /// Column of a word, or `otherwise` where it is missing.
  std::uint32_t column_or(char letter, std::uint32_t otherwise) const {
    return has(letter) ? (*this)[letter].column : otherwise;
  }
  /// Smallest column of the given letters in the block; 0: none.
  std::uint32_t first_column(Letters letters) const;
};

}  // namespace feedscope::iso
