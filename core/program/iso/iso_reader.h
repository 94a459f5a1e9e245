#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/iso/drilling_cycle.h"
#include "core/program/iso/flow_index.h"
#include "core/program/iso/g_codes.h"
#include "core/program/iso/iso_coordinates.h"
#include "core/program/iso/iso_expression.h"
#include "core/program/iso/iso_variables.h"
#include "core/program/iso/modal_state.h"
#include "core/program/reader.h"
#include "core/program/text/lexer.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

/// Reads what ISO controls share, and Fanuc, LinuxCNC and grbl. README.md beside program.h gives the words.
class IsoReader : public Reader, private VariableSource {
 public:
  /// `options.dialect` says which of them; none: Dialect::iso. `absolute_centers`: I J K are positions until
  /// the program says otherwise (G91.1), a parameter of some controls.
  IsoReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress,
            bool absolute_centers = false);

  /// After read(): most arcs by a centre do not fit, and the program does not say how its I J K are meant.
  bool doubts_centers() const;
  /// After read(): every arc by a centre fits.
  bool centers_fit() const { return path().centers().misfits == 0; }

 private:
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

  /// The words of one block by letter, and what its G words ask for beyond modal changes.
  struct Words {
    std::array<Word, 26> by_letter;
    std::uint32_t present = 0;                         ///< bit per letter
    std::array<const GCode*, g_group_count> groups{};  ///< the block's code of each group
    bool other_codes = false;                          ///< G or M words that P, Q, L, R, I ... may belong to
    bool own_words = false;                            ///< an unread code owns the coordinates
    std::uint32_t dwell = 0;                           ///< column of G4; 0: none
    bool exact_stop = false;                           ///< G9
    bool stop = false;                                 ///< M0, M1, M60
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
    bool has(char letter) const { return (present >> (letter - 'A') & 1U) != 0; }
    bool has_any(Letters letters) const { return (present & letters.mask) != 0; }
    bool has_polar() const { return distance != nullptr || angle != nullptr; }
    const Word& operator[](char letter) const { return by_letter[static_cast<std::size_t>(letter - 'A')]; }
    /// Of those that the block has; 0: none.
    std::uint32_t first_column(Letters letters) const;
  };

  void run_line(std::string_view line) override;
  std::uint32_t first_word(std::string_view line) override;
  void run_out() override { leave_call(); }
  void left_call() override;

  /// `readable`: false for a block of which words could not be read; it does not move.
  void run_block(const Block& block, bool readable);
  static bool calls_macro(const Block& block);
  void report_faults(const Block& block);
  void gather(const Block& block);
  void apply_g(const Block& block, const Word& word);
  void apply_modal(const GCode& code, const Word& word);
  void report_unread(const GCode& code, const Word& word);
  void apply_feed();
  void check_rotary();
  void check_unused();

  void move();
  void dwell();
  /// The words are those of a printer or plotter, not of grbl.
  bool is_printer();
  void arc(const Vec3& target);
  double extra_turns();
  void check_center_axis();
  void check_inverse_time();
  void cut_corner(bool at_line_or_arc);
  void program_axes_of_block();
  void check_point(char letter);
  Vec3 target_of_block();
  Vec3 center_of_block(bool absolute) const;

  // Lines with variables, expressions and names: iso_statement.cpp.
  struct Assignment {
    std::uint32_t number = 0;
    std::string name;  ///< empty: by number
    double value = 0;
    std::uint32_t column = 0;
  };
  /// True if "%" follows.
  bool run_statement(const Block& block);
  std::string_view without_comments(const Block& block);
  /// Words and assignments from here on.
  void run_items(Scanner& scan);
  /// False, and reported, if one of them cannot be read.
  bool read_items(Scanner& scan);
  void read_word(Scanner& scan);
  double read_value(Scanner& scan, bool& has_point);
  void read_assignment(Scanner& scan);
  void assign(const Assignment& assignment);
  void report_fault(const ReadFault& fault);

  // What variables hold: iso_parameters.cpp.
  double numbered(std::uint32_t number, std::uint32_t column) override;
  double named(const std::string& name, std::uint32_t column) override;
  bool has_name(const std::string& name) const override;
  double unset(std::uint32_t number, std::uint32_t column);
  std::optional<double> built_in(std::uint32_t number) const;
  std::optional<double> built_in(std::string_view name) const;
  std::optional<double> fanuc_modal(std::uint32_t number) const;
  /// Axis of a work offset.
  struct OffsetVariable {
    int key = 0;
    int axis = 0;
  };
  std::optional<OffsetVariable> offset_variable(std::uint32_t number) const;
  void set_offset_variable(const OffsetVariable& variable, double value);
  double position_of(int axis) const;
  double feed_word() const;
  void raise_alarm(double number, std::uint32_t column);

  // Jumps and loops: iso_flow.cpp.
  bool run_flow(const Block& block, Scanner& scan);
  bool run_o_word(const Block& block, Scanner& scan);
  void run_o_word(FlowWord word, const std::string& label, std::uint32_t column, Scanner& scan);
  bool run_macro_statement(Scanner& scan);
  bool run_branch_statement(Scanner& scan);
  void run_if(Scanner& scan);
  void go_to(Scanner& scan);
  /// A condition that cannot be read is reported and does not hold.
  bool condition(Scanner& scan);
  /// Reports what stands behind a statement that has been read.
  void report_rest(Scanner& scan);
  /// What else stands in the line has no effect.
  static void leave_line(Scanner& scan);
  void report_nested_subs(const FlowIndex::Statement& statement);
  void begin_branch(bool holds, const FlowIndex::Statement& statement);
  void begin_repeat(Scanner& scan, const FlowIndex::Statement& statement);
  void end_repeat(const FlowIndex::Statement& statement);
  void leave_loop(bool for_good, const FlowIndex::Statement& loop);
  void begin_loop(bool holds, const FlowIndex::Statement& statement);
  const FlowIndex& flow_index(const SourceText& text);

  // M words, tools, lines that are no blocks: iso_m_codes.cpp.
  struct KeptState;
  void apply_m(const Word& word);
  void keep_modal_state(const Word& word);
  void restore(const KeptState& kept);
  void ask_for_tool(double number);
  /// A line of words that are none to the dialect; it is dealt with.
  bool is_no_block(const Block& block) {
    return dialect_ == Dialect::fanuc  ? begins_next_program(block)
           : dialect_ == Dialect::grbl ? is_grbl_command(block)
                                       : false;
  }
  /// Fanuc: a program ends where the O number of the next one stands.
  bool begins_next_program(const Block& block);
  bool is_grbl_command(const Block& block);

  // Subprograms and macros: iso_calls.cpp.
  struct Repeat {
    std::uint32_t line = 0;
    double left = 0;  ///< passes, the one that runs included
  };
  /// What M70 keeps, of `state` what LinuxCNC restores.
  struct KeptState {
    ModalState state;
    FeedMode feed_mode = FeedMode::per_minute;
    double feed = 0;
    PathControl path_control;
    bool until_return = false;  ///< M73
  };
  /// What a call holds; the first is the program's own.
  struct Frame {
    std::uint32_t called_from = 0;                  ///< line
    std::optional<IsoVariables::Locals> arguments;  ///< none: the caller's local variables go on
    std::vector<Repeat> repeats;                    ///< innermost last
    std::optional<KeptState> kept;
    std::uint32_t program = 0;  ///< line of the O number that it began with; 0: none
  };
  struct Subprogram {
    std::shared_ptr<const SourceText> text;  ///< nullptr: not found
    std::uint32_t line = 0;
  };
  struct MacroCall {
    double program = 0;
    std::uint32_t column = 0;
    double times = 1;
    Subprogram found;
    IsoVariables::Locals arguments{};
    std::size_t depth = 0;  ///< of calls, at which G66 stands
  };
  void run_calls(bool sound);
  void call_subprogram(const Word& word);
  void call_blocks(const Word& word);
  void return_to(const Word& word);
  void call_o_word(const std::string& label, std::uint32_t column, Scanner& scan);
  void return_from_o_word(Scanner& scan);
  void gather_macro_call(const Block& block);
  void call_macro(const MacroCall& macro);
  void enter(const Subprogram& subprogram, double times,
             const std::optional<IsoVariables::Locals>& arguments);
  void leave_call();
  Subprogram find_program(double number);
  Subprogram find_o_word(const std::string& label);
  double repeats_of_block();
  void call_named_file(const Word& word);
  void report_missing(const std::string& who, const std::string& file, std::uint32_t column);

  // What rules the motion at the ends of blocks: iso_path_control.cpp.
  void apply_path_control(const GCode& code);
  void set_tolerances(PathControl& control);
  std::optional<double> tolerance(char letter, std::string_view of);
  void move_to_exact_stop();
  void report_precision_level();

  // What G words other than those of motion do with the block's words: iso_functions.cpp.
  void add_function(int code, std::uint32_t column);
  void run_functions();
  void run_function(int code, std::uint32_t column);
  void set_frame() { path().set_frame(coordinates_.frame()); }
  /// X Y Z of the block as they stand [mm]; `otherwise` for missing ones.
  Vec3 programmed_axes(const Vec3& otherwise) const;
  bool lacks(std::string_view code, char letter, int g, std::uint32_t column, std::string_view effect);
  static std::string offset_name(int key);
  void take_given_offsets();
  void select_work_offset(int code, std::uint32_t column);
  void set_data(std::uint32_t column);
  std::optional<int> offset_key(std::uint32_t column, bool further);
  void set_work_offset(bool further, std::uint32_t column);
  void preset_work_offset(std::uint32_t column);
  void store_work_offset(int key, const IsoCoordinates::WorkOffset& offset);
  void set_tool_radius(int kind, std::uint32_t column);
  void rotate(std::uint32_t column);
  void rotate_in_space(std::uint32_t column);
  void tilt(std::uint32_t column);
  void report_tilt(std::uint32_t column);
  void report_levelling(std::uint32_t column);
  void check_turning(std::uint32_t column);
  void scale(std::uint32_t column);
  double scale_factor(const Word& word);
  void mirror(bool on);
  void go_to_reference(int code, std::uint32_t column);
  void return_from_reference();
  void go_to_machine_coordinates(std::uint32_t column);
  std::array<bool, 3> axes_of_block() const;

  // G40 to G42.1: iso_compensation.cpp.
  void compensate(int code, std::uint32_t column);
  void renew_compensation();
  void begin_compensation(std::uint32_t column);
  std::optional<double> compensation_radius(int code, std::uint32_t column);

  // Polar coordinates: iso_polar.cpp.
  Vec3 polar_target(Vec3 target);
  Vec3 distance_and_angle_target(Vec3 target);

  // Splines: iso_splines.cpp.
  struct ControlPoint {
    Vec3 at = Vec3::Zero();  ///< [mm]
    double weight = 1;
    std::uint32_t line = 0;  ///< shown
    DiagnosticLog::Place place;
  };
  struct Nurbs {
    std::vector<ControlPoint> points;  ///< empty outside of G5.2
    std::size_t order = 3;
    Vec3 end = Vec3::Zero();    ///< last point [mm]
    std::vector<double> knots;  ///< Fanuc's; empty: a clamped curve
  };
  void begin_spline(const GCode& code, const Word& word);
  void run_spline();
  void cubic_spline();
  void quadratic_spline();
  /// Parameter from 0 to 1, in programmed coordinates.
  void write_curve(const ParametricCurve& curve);
  /// In the plane XY [mm].
  Vec3 offset_words(char first, char second) const;
  /// True, reported and a line written, if the block has neither of the two.
  bool lacks_spline_words(char first, char second);
  void add_control_point();
  /// X Y Z of the block, absolute or from `place` on.
  Vec3 target_from(const Vec3& place) const;
  void add_fanuc_control_point();
  void end_nurbs();
  void end_fanuc_nurbs();
  void write_nurbs(const std::vector<ControlPoint>& points, const std::vector<double>& knots);
  void finish() override;

  // Drilling cycles: iso_cycles.cpp.
  void begin_cycle(const GCode& code, const Word& word);
  void run_cycle();
  void gather_cycle();
  /// None, and reported, if it has no bottom or no levels that fit.
  std::optional<DrillingCycle> drilling_cycle(std::uint32_t column, double repeats);
  void return_to_retract_plane();
  void gather_pecks();
  void drill_pattern(int code, std::uint32_t column);
  bool check_cycle(std::uint32_t column);
  double cycle_repeats();

  Dialect dialect_;
  Lexer lexer_;
  Lexer argument_lexer_;            ///< for arguments of macros
  std::optional<bool> is_printer_;  ///< once a dwell has asked
  ModalState state_;
  Nurbs nurbs_;
  IsoCoordinates coordinates_;
  std::map<int, double> tool_radii_;  ///< by offset number [mm]
  Words words_;
  bool words_met_ = false;      ///< from then on "%" ends the program
  bool centers_named_ = false;  ///< G90.1 or G91.1
  IsoVariables variables_;
  IsoExpression expression_;
  std::string statement_text_;
  Block statement_;
  std::vector<Assignment> assignments_;
  std::map<const SourceText*, FlowIndex> flow_;
  std::uint32_t tested_branch_ = 0;  ///< line of an "elseif" or "else" that an if jumps to; 0: none
  std::map<std::uint32_t, std::shared_ptr<const SourceText>> program_files_;  ///< by number, nullptr: none
  std::vector<Frame> frames_{1};
  std::optional<MacroCall> modal_macro_;
};

}  // namespace feedscope
