#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/program/heidenhain/heidenhain_core.h"

namespace feedscope {

/// Reads Heidenhain DIN/ISO programs; README.md beside this file gives the words.
class HeidenhainIsoReader : public HeidenhainCore {
 public:
  HeidenhainIsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                      Progress* progress)
      : HeidenhainCore(std::move(source), options, progress) {}

 private:
  /// The words of a block, as far as no code has a grammar of its own.
  struct Block {
    MotionWords motion;
    std::array<int, 16> codes{};
    int code_count = 0;
    std::uint32_t column = 0;
    std::uint32_t code_column = 0;                 ///< of the first G
    std::array<OptionalWord, 3> pole;              ///< I, J, K
    std::optional<double> radius;                  ///< R, as written
    std::optional<double> angle;                   ///< H, as written
    std::optional<std::string> label;              ///< L
    std::optional<double> repeats;                 ///< L5,3
    ToolCall tool;                                 ///< T, S, DR
    std::array<std::optional<double>, 10> values;  ///< P01 to P09

    bool has(int code) const;
  };

  void run_statement(std::string_view statement) override;
  std::string label_on(std::string_view line) override;
  std::uint32_t first_word(std::string_view line) override;
  Dialect dialect() const override { return Dialect::heidenhain_iso; }

  void run_percent(std::string_view rest, std::uint32_t column);
  void run_d_function(Scanner& scanner, std::uint32_t column);
  /// False where a cycle has taken the rest of the block.
  bool read_block(Scanner& scanner, Block& block);
  bool read_word(Scanner& scanner, Block& block);
  bool read_code(Scanner& scanner, std::uint32_t column, Block& block);
  void read_coordinate(Scanner& scanner, char letter, std::uint32_t column, Block& block);
  void read_label(Scanner& scanner, Block& block);

  void run_block(Block& block);
  void apply_modes(Block& block);
  /// True if a code of the block has used its coordinates.
  bool run_codes(const Block& block);
  bool run_transformation(int code, const Block& block);
  bool run_corner_code(int code, const Block& block);
  void run_old_cycle(int number, const Block& block);
  void run_tool(const Block& block);
  void run_motion(Block& block);
  /// With the rapid of G0 or G10 in force.
  MotionWords with_modal_rapid(MotionWords words) const;
  void report_code(int code, std::uint32_t column);

  bool begun_ = false;
  bool incremental_ = false;
  int motion_ = -1;                          ///< G in force; -1: none yet
  std::optional<double> leaving_radius_;     ///< G27, until the next motion [mm]
  std::optional<ContourFeed> leaving_feed_;  ///< of its arc
};

}  // namespace feedscope
