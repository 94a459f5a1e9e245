#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/program/iso/g_codes.h"
#include "core/program/iso/modal_state.h"
#include "core/program/reader.h"
#include "core/program/text/lexer.h"

namespace feedscope {

/// Reads what ISO controls share, and Fanuc, LinuxCNC and grbl. README.md beside program.h gives the words.
class IsoReader : public Reader {
 public:
  IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress)
      : Reader(std::move(source), options, progress) {}

 private:
  /// The words of one block by letter, and what its G words ask for beyond modal changes.
  struct Words {
    std::array<Word, 26> by_letter;
    std::uint32_t present = 0;                         ///< bit per letter
    std::array<const GCode*, g_group_count> groups{};  ///< the block's code of each group
    bool other_codes = false;                          ///< G or M words that P, Q, L, R, I ... may belong to
    bool own_words = false;                            ///< an unread code owns the coordinates
    std::uint32_t dwell = 0;                           ///< column of G4; 0: none

    void clear();
    bool has(char letter) const { return (present >> (letter - 'A') & 1U) != 0; }
    bool has_any(std::string_view letters) const;
    const Word& operator[](char letter) const { return by_letter[static_cast<std::size_t>(letter - 'A')]; }
    std::uint32_t first_column(std::string_view letters) const;
  };

  void run_line(std::string_view line) override;
  std::uint32_t first_word(std::string_view line) override;

  void run_block(const Block& block);
  void report_faults(const Block& block);
  void report_statement(const Block& block);
  void gather(const Block& block);
  void apply_g(const Block& block, const Word& word);
  void apply_modal(const GCode& code, const Word& word);
  void report_unread(const GCode& code, const Word& word);
  void apply_m(const Word& word);
  void apply_feed();
  void check_rotary();
  void check_unused();

  void move();
  void dwell();
  void arc(const Vec3& target);
  double extra_turns();
  void check_center_axis();
  Vec3 target_of_block() const;
  Vec3 center_of_block(bool absolute) const;

  Lexer lexer_;
  ModalState state_;
  Words words_;
  bool words_met_ = false;  ///< from then on "%" ends the program
};

}  // namespace feedscope
