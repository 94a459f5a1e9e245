#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/program/heidenhain/heidenhain_core.h"

namespace feedscope {

/// The words of one pattern of PATTERN DEF; lengths in mm, angles in degrees.
struct PatternWords {
  double x = 0;
  double y = 0;
  double z = 0;        ///< on top of the cycle's surface
  double spacing = 0;  ///< D: of a row, or the circle's diameter
  double column_spacing = 0;
  double row_spacing = 0;
  double count = 0;
  double columns = 0;
  double rows = 0;
  double turn = 0;
  double first_turn = 0;
  double second_turn = 0;
  double start = 0;
  double step = 0;
};

/// Reads Heidenhain conversational programs; README.md beside this file gives the words.
class HeidenhainReader : public HeidenhainCore {
 public:
  HeidenhainReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress)
      : HeidenhainCore(std::move(source), options, progress) {}

 private:
  using Handler = void (HeidenhainReader::*)(Scanner&, std::uint32_t column);
  struct Statement {
    std::string_view name;
    Handler run = nullptr;
  };
  static const Statement* find_statement(std::string_view name);

  void run_statement(std::string_view statement) override;
  /// The end of the program counts as none.
  std::uint32_t first_word(std::string_view line) override;
  std::string label_on(std::string_view line) override;
  Dialect dialect() const override { return Dialect::heidenhain; }

  void report_unread(std::string_view name, std::string_view statement, std::uint32_t column);
  void report_unknown(std::string_view statement, std::uint32_t column);

  // heidenhain_words.cpp
  /// All words up to the end of the statement.
  MotionWords words(Scanner& scanner);
  bool axis_word(Scanner& scanner, char letter, bool incremental, std::uint32_t column, MotionWords& words);
  bool normal_word(Scanner& scanner, std::uint32_t column);
  void feed_word(Scanner& scanner, std::uint32_t column, MotionWords& words);
  void radius_word(Scanner& scanner, std::uint32_t column, MotionWords& words);

  void line(Scanner& scanner, std::uint32_t column);
  void pole(Scanner& scanner, std::uint32_t column);
  void center_arc(Scanner& scanner, std::uint32_t column);
  void radius_arc(Scanner& scanner, std::uint32_t column);
  void tangent_arc(Scanner& scanner, std::uint32_t column);
  void polar_line(Scanner& scanner, std::uint32_t column);
  void polar_arc(Scanner& scanner, std::uint32_t column);
  void polar_tangent_arc(Scanner& scanner, std::uint32_t column);
  void rounding(Scanner& scanner, std::uint32_t column);
  void chamfer(Scanner& scanner, std::uint32_t column);
  void run_arc(PathKind kind, Scanner& scanner, std::uint32_t column);
  void approach(Scanner& scanner, std::uint32_t column);
  void departure(Scanner& scanner, std::uint32_t column);
  /// Of APPR or DEP, and whether the point is polar. Throws ReadFault.
  static std::pair<ApproachKind, bool> approach_name(Scanner& scanner);

  // heidenhain_statements.cpp

  void begin(Scanner& scanner, std::uint32_t column);
  void end(Scanner& scanner, std::uint32_t column);
  void blank_form(Scanner& scanner, std::uint32_t column);
  void tool(Scanner& scanner, std::uint32_t column);
  void tool_definition(Scanner& scanner);
  void tool_call(Scanner& scanner);
  void label_statement(Scanner& scanner, std::uint32_t column);
  void call_statement(Scanner& scanner, std::uint32_t column);
  void stop(Scanner& scanner, std::uint32_t column);
  void declaration(Scanner& scanner, std::uint32_t column);
  void function(Scanner& scanner, std::uint32_t column);
  void arithmetic(Scanner& scanner, FunctionCall& call);
  void jump_condition(Scanner& scanner, FunctionCall& call);
  /// "Q1 IS UNDEFINED" as a condition; false, and the scanner stays, if none stands here.
  bool definition_condition(Scanner& scanner, FunctionCall& call);
  void transformation(Scanner& scanner, std::uint32_t column);
  void function_statement(Scanner& scanner, std::uint32_t column);
  void global_definition(Scanner& scanner, std::uint32_t column);
  void preset(Scanner& scanner, std::uint32_t column);
  void select(Scanner& scanner, std::uint32_t column);

  // heidenhain_cycle_lines.cpp
  void cycle(Scanner& scanner, std::uint32_t column);
  void cycle_call(Scanner& scanner, std::uint32_t column);
  void old_cycle_line(int number, int part, Scanner& scanner, std::uint32_t column);
  void transformation_cycle(int number, Scanner& scanner, std::uint32_t column);
  void datum_shift(Scanner& scanner, std::uint32_t column);
  void mirror(Scanner& scanner, std::uint32_t column);
  void rotation(Scanner& scanner, std::uint32_t column);
  void scaling(Scanner& scanner, std::uint32_t column);
  void axis_scaling(Scanner& scanner);
  void tolerance(int part, Scanner& scanner, std::uint32_t column);
  static int axis_letter(Scanner& scanner);

  // heidenhain_planes.cpp
  void plane_statement(Scanner& scanner, std::uint32_t column);
  /// [rad]; zero where a name is missing.
  std::array<double, 3> named_angles(Scanner& scanner, const std::array<std::string_view, 3>& names);
  CoordinateFrame vector_plane(Scanner& scanner, std::uint32_t column);
  CoordinateFrame points_plane(Scanner& scanner, std::uint32_t column);
  void skip_turning_words(Scanner& scanner);
  void tilt_cycle(Scanner& scanner, std::uint32_t column);
  /// By A, B and C; none if none of them stands here.
  std::optional<CoordinateFrame> axis_plane(Scanner& scanner, std::uint32_t column);

  // heidenhain_patterns.cpp
  void pattern(Scanner& scanner, std::uint32_t column);
  PatternWords read_pattern(Scanner& scanner);
  double factor(Scanner& scanner);

  std::vector<std::string_view> said_;  ///< statements that are said once
  std::string selected_program_;        ///< SEL PGM
};

}  // namespace feedscope
