#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/program/path/plane.h"
#include "core/program/reader.h"
#include "core/program/sinumerik/arguments.h"
#include "core/program/sinumerik/block_words.h"
#include "core/program/sinumerik/drilling_cycle.h"
#include "core/program/sinumerik/frame_value.h"
#include "core/program/sinumerik/frames.h"
#include "core/program/sinumerik/functions.h"
#include "core/program/sinumerik/macros.h"
#include "core/program/sinumerik/path_words.h"
#include "core/program/sinumerik/program_index.h"
#include "core/program/sinumerik/spline_path.h"
#include "core/program/sinumerik/values.h"
#include "core/program/text/lexer.h"

namespace feedscope {

/// Reads programs of the Sinumerik 840D and its relatives; README.md beside it gives the words.
class SinumerikReader : public Reader {
 public:
  SinumerikReader(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);

 private:
  /// About the pole [rad, mm]; none: not programmed yet.
  struct Polar {
    std::optional<double> angle;
    std::optional<double> radius;
  };
  /// What stays in force from block to block.
  struct Modal {
    const sinumerik::Function* motion = nullptr;  ///< nullptr: none yet
    Plane plane = Plane::xy;
    bool inch = false;
    bool inch_feed = false;
    bool incremental = false;
    int work_offset = 0;  ///< G number; 0: none yet
    Vec3 pole = Vec3::Zero();
    Polar polar;
    bool surface_speed = false;                              ///< G96: S is no spindle speed
    std::string tool;                                        ///< T, number or name; empty: none yet
    double edge = 1;                                         ///< D
    const sinumerik::Function* compensation = nullptr;       ///< G41, G42
    bool corner_lines = false;                               ///< G451
    double rounding = 0;                                     ///< RNDM [mm]; 0: none
    double corner_feed = 0;                                  ///< FRCM as written; 0: none
    std::array<double, 3> axis_feeds{};                      ///< FA [mm/s]; 0: none
    sinumerik::Action diameters = sinumerik::Action::radii;  ///< of X
  };
  /// A subprogram that runs.
  struct Scope {
    std::string name;
    sinumerik::Arguments arguments;
    std::vector<std::pair<std::string, std::string>> returned;  ///< own variable, caller's: VAR parameters
    bool words_met = false;
    bool ends_caller = false;  ///< the block of the call holds M17 or M30 too
    bool saves = false;        ///< PROC ... SAVE
    Modal modal;               ///< of the caller
    sinumerik::Frames frames;
    sinumerik::PathWords path_words;
  };
  /// REPEAT, REPEATB.
  struct Repeat {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;     ///< last line that runs
    std::uint32_t resume = 0;  ///< line behind the statement
    std::uint32_t left = 0;    ///< runs, this one included
    std::size_t depth = 0;
  };
  struct SubprogramCall {
    std::string name;
    std::uint32_t column = 0;
    sinumerik::Arguments arguments;
    bool bracketed = false;
  };
  /// MCALL: a cycle or subprogram behind every motion.
  struct ModalCall {
    SubprogramCall call;
    std::size_t depth = 0;
  };

  // In lines with macros places are those that are written.
  std::uint32_t written(std::uint32_t column) const {
    return replaced_ ? replaced_->written_column(column) : column;
  }
  DiagnosticLog::Place place(std::uint32_t column) const { return Reader::place(written(column)); }
  template <typename MakeText>
  void report(Severity severity, std::string_view code, int detail, std::uint32_t column, MakeText&& text) {
    Reader::report(severity, code, detail, written(column), text);
  }

  // Lines and plain words: sinumerik_reader.cpp
  void run_line(std::string_view line) override;
  void run_out() override;
  void left_call() override;
  void before_finish() override { finish_spline(); }
  std::uint32_t first_word(std::string_view line) override;
  void run_head(std::string_view line);
  void run_block(const Block& block);
  bool report_faults(const Block& block);
  void gather(const Block& block);
  void set_letter(char letter, const sinumerik::BlockWords::Value& value, std::string_view written);
  void apply_m(double number);
  void apply_g(double number, std::uint32_t column, std::string_view written);
  void execute_block(bool sound);
  void finish_block();
  void run_m_functions();
  void end_or_return();

  // What functions and F do: modal_words.cpp
  void apply(const sinumerik::Function& function, std::uint32_t column);
  void apply_action(const sinumerik::Function& function);
  void check_group(const sinumerik::Function& function, std::uint32_t column);
  void apply_feed();
  double feed_of(double value) const;
  void set_plane(Plane plane);
  void set_frame();
  void keep_coordinates();
  void apply_frame();
  Vec3 frame_values(double missing) const;
  Vec3 frame_angles() const;
  void apply_pole();
  double to_mm(double value) const;

  // Frames in variables, settable ones: frame_variables.cpp
  bool run_frame_variable(Scanner& scanner, std::string_view name);
  bool run_frame_assignment(Scanner& scanner, std::string_view name);
  void define_frames(Scanner& scanner);
  void assign_frame(Scanner& scanner, sinumerik::FrameValue& value, bool one_part);
  void set_frame_part(sinumerik::FrameValue& value, sinumerik::FrameValue::Part part, std::string_view axis,
                      double number, std::uint32_t column);
  void set_programmed_part(Scanner& scanner);
  int frame_index(Scanner& scanner);
  sinumerik::FrameValue read_frame(Scanner& scanner);
  sinumerik::FrameValue frame_operand(Scanner& scanner);
  sinumerik::FrameValue frame_of_list(Scanner& scanner, sinumerik::FrameValue::Part part);
  void change_work_offset(int number, std::uint32_t column);

  // Cutter radius: compensation.cpp
  void set_tool_radius(Scanner& scanner);
  void apply_compensation();
  void choose_tool(const std::string& name);
  void report_tool_radius(const std::string& cutter);

  // Roundings and chamfers: corners.cpp
  void apply_modal_corners();
  void cut_corner(bool at_line_or_arc);

  // Statements: statements.cpp, assignments.cpp
  void run_statements(Scanner& scanner);
  void run_item(Scanner& scanner);
  void run_word(Scanner& scanner);
  void run_extended(Scanner& scanner, std::string_view name, std::uint32_t column);
  void run_letter(Scanner& scanner);
  void run_name(Scanner& scanner);
  void run_system_variable(Scanner& scanner);
  bool run_assignment(Scanner& scanner, std::string_view name);
  bool run_address(Scanner& scanner, std::string_view name, std::uint32_t column);
  bool run_path_value(Scanner& scanner, std::string_view name, std::uint32_t column);
  void run_function(Scanner& scanner, const sinumerik::Function& function, std::uint32_t column);
  void run_polynomial(Scanner& scanner);
  void skip_value(Scanner& scanner);
  sinumerik::BlockWords::Value coordinate(Scanner& scanner, std::uint32_t column);
  void take_given_offsets();
  void report_axis(std::string_view name, std::uint32_t column, double value);

  // Axes that move on their own: positioning_axes.cpp
  void run_pos(Scanner& scanner);
  void run_axis_feed(Scanner& scanner);
  void move_positioning_axes();

  // Flow: flow.cpp
  using Run = void (SinumerikReader::*)(Scanner&);
  static Run find_statement(std::string_view name);
  const sinumerik::ProgramIndex& index_of(const SourceText& text);
  const sinumerik::ProgramIndex& index() { return index_of(text()); }
  sinumerik::ProgramIndex::Structure structure(Scanner& scanner, std::string_view word);
  void run_if(Scanner& scanner);
  void run_else(Scanner& scanner);
  void run_endif(Scanner& scanner);
  void run_for(Scanner& scanner);
  void run_endfor(Scanner& scanner);
  void run_while(Scanner& scanner);
  void run_loop(Scanner& scanner);
  void run_end_of_loop(Scanner& scanner);
  void run_until(Scanner& scanner);
  void run_repeat(Scanner& scanner);
  void run_repeatb(Scanner& scanner);
  void run_case(Scanner& scanner);
  void run_goto(Scanner& scanner);
  void run_gotof(Scanner& scanner);
  void run_gotob(Scanner& scanner);
  void run_gotoc(Scanner& scanner);
  void run_gotos(Scanner& scanner);
  std::string label(Scanner& scanner);
  void jump(Scanner& scanner, bool forward, bool backward, bool must);
  bool jump_if(Scanner& scanner, bool condition);
  std::uint32_t label_line(const std::string& label, std::uint32_t column);
  void add_repeat(std::uint32_t begin, std::uint32_t end, Scanner& scanner);
  std::uint32_t repeat_count(Scanner& scanner);
  bool repeat_is_over(std::uint32_t next);
  void run_synchronized(Scanner& scanner);

  // Subprograms and definitions: calls.cpp
  void run_def(Scanner& scanner);
  void run_proc(Scanner& scanner);
  void bind(Scanner& scanner, std::size_t position);
  sinumerik::Variable take_array(Scanner& scanner, sinumerik::Type type, std::size_t position,
                                 std::string_view name);
  void run_extern(Scanner& scanner);
  void run_define(Scanner& scanner);
  void run_ret(Scanner& scanner);
  void run_call(Scanner& scanner);
  void run_extcall(Scanner& scanner);
  void run_isocall(Scanner& scanner);
  void run_mcall(Scanner& scanner);
  SubprogramCall read_call(Scanner& scanner);
  sinumerik::Arguments read_arguments(Scanner& scanner);
  void run_subprogram(const SubprogramCall& call, std::uint32_t times);
  bool run_cycle(const SubprogramCall& call);
  bool enter(const SubprogramCall& call, std::shared_ptr<const SourceText> text, std::uint32_t line,
             std::uint32_t times);

  // Where a block goes: targets.cpp
  Vec3 target_of_block();
  bool is_incremental(const sinumerik::BlockWords::Value& word) const;
  bool is_diameter(const sinumerik::BlockWords::Value& word) const;
  double increment_base(int axis, const Vec3& start);
  void program_axis(int axis);
  Polar polar_of_block() const;
  Vec3 polar_target(const Vec3& straight_target) const;
  void angle_target(Vec3& target);

  // Motion: motion.cpp, arcs.cpp
  void move();
  void program_axes();
  bool has_motion_words() const;
  void move_machine_axes();
  void dwell();
  void straight(const Vec3& target, bool rapid);
  void thread(const Vec3& target);
  void collect_spline(const Vec3& target);
  void finish_spline();
  void polynomial(const Vec3& target, Vec3& from);
  void use_path_control(bool rapid);
  void check_unused(bool arc);
  void arc(const Vec3& target);
  void plain_arc(const Vec3& target, ArcRequest& request);
  void angle_arc(const Vec3& target, ArcRequest& request);
  void arc_through(const Vec3& target);
  void tangent_arc(const Vec3& target);
  Vec3 center_of_block() const;
  Vec3 last_direction() const;

  // Cycles: cycles.cpp
  void check_depth(int number, const SubprogramCall& call);
  sinumerik::DrillingPlace drilling_place();
  void drill(const DrillPlan& plan);
  void hole_pattern(const sinumerik::Arguments& arguments, bool circle, std::uint32_t column);
  void high_speed_settings(const SubprogramCall& call);
  void swivel(const SubprogramCall& call);

  Lexer lexer_{Brackets::statement};
  Modal modal_;
  sinumerik::BlockWords words_;
  std::array<const sinumerik::Function*, sinumerik::group_count> groups_{};
  const sinumerik::Function* own_block_ = nullptr;  ///< takes the block's coordinates
  std::uint32_t own_column_ = 0;
  std::uint32_t compensation_column_ = 0;
  CutterRadii tool_radii_;         ///< that the program sets
  bool machine_axes_ = false;      ///< G53, G153, SUPA
  std::string_view machine_word_;  ///< which of them
  int fixed_point_ = 1;            ///< FP of G75
  bool tool_change_ = false;       ///< M6
  bool spindle_start_ = false;     ///< M3, M4
  bool spindle_stop_ = false;      ///< M5, M19
  bool stop_ = false;              ///< M0, M1
  bool exact_stop_ = false;        ///< G9
  bool ends_ = false;              ///< M2, M17, M30, RET
  bool moved_ = false;             ///< the block did
  std::optional<SubprogramCall> call_;
  sinumerik::Values values_;
  sinumerik::Frames frames_;
  std::map<int, sinumerik::FrameValue> settable_frames_;  ///< that the program sets, by number: G54 is 1
  sinumerik::FrameValue settable_frame_;                  ///< in force
  std::map<std::string, sinumerik::FrameValue> frame_variables_;
  sinumerik::Macros macros_;
  std::optional<sinumerik::Macros::Line> replaced_;  ///< the line in force, where it holds macros
  /// Of axes that have not been programmed since a frame changed: what they were before it [mm].
  std::array<std::optional<double>, 3> kept_coordinates_;
  sinumerik::PathWords path_words_;
  sinumerik::SplinePath spline_;
  std::array<std::optional<sinumerik::PolynomialWord>, 3> polynomials_;
  bool has_polynomials_ = false;
  std::array<std::optional<sinumerik::BlockWords::Value>, 3> positions_;  ///< POS[X] to POS[Z]
  bool has_positions_ = false;
  std::vector<Scope> scopes_;
  std::vector<Repeat> repeats_;
  std::optional<ModalCall> modal_call_;
  std::map<const SourceText*, std::unique_ptr<sinumerik::ProgramIndex>> indices_;
  std::map<std::string, double> other_axes_;  ///< rotary and secondary ones, and where they are
  bool oriented_ = false;                     ///< TRAORI
  bool words_met_ = false;                    ///< in the program itself
  enum class Applied { none, feed, rapid } applied_ = Applied::none;  ///< path control in force
  Vec3 start_ = Vec3::Zero();  ///< of the last motion, and that motion, for CT
  std::optional<ArcRequest> last_arc_;
  bool last_by_radius_ = false;
};

}  // namespace feedscope
