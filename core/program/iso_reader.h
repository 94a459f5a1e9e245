#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/program/arc_solver.h"
#include "core/program/diagnostic_log.h"
#include "core/program/g_codes.h"
#include "core/program/lexer.h"
#include "core/program/modal_state.h"
#include "core/program/program.h"

namespace feedscope {

/// Interprets blocks of the ISO core. README.md beside this file gives the words and rules.
class IsoReader {
 public:
  IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options);

  /// Reads the whole source, once.
  Program read(Progress* progress);

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

  void read_block(const Block& block);
  void report_faults(const Block& block);
  void gather(const Block& block);
  void apply_g(const Block& block, const Word& word);
  void apply_modal(const GCode& code, const Word& word);
  void report_unread(const GCode& code, const Word& word);
  void apply_m(const Word& word);
  void apply_feed();
  void check_rotary();
  void check_unused();
  void report_text_after_end();
  void report_nothing_read();

  void move();
  void dwell();
  void arc(const Vec3& target);
  double extra_turns();
  void report_arc_fault(const ArcSolution& solution, const Vec3& target, const Vec3& axis);
  void check_center_axis();
  double usable_feed();
  void add_motion(Motion motion, const Vec3& target, std::int32_t arc_index = -1);
  void extend_bounds(Motion motion, const Vec3& target);
  Vec3 target_of_block() const;
  Vec3 center_of_block(bool absolute) const;

  template <typename MakeText>
  void report(Severity severity, std::string_view code, int detail, std::uint32_t column, MakeText&& text) {
    log_.add(severity, code, detail, {line_, column}, text);
  }

  ReadOptions options_;
  Program program_;
  DiagnosticLog log_;
  Lexer lexer_;
  ModalState state_;
  Words words_;
  std::array<bool, 3> axis_known_{};
  bool feed_missed_ = false;
  bool words_met_ = false;  ///< from then on "%" ends the program
  std::uint32_t line_ = 0;
  std::uint32_t end_line_ = 0;  ///< of M2, M30, M99 or the closing "%"; 0: not met
};

}  // namespace feedscope
