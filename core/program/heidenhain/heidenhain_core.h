#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/program/heidenhain/contour_writer.h"
#include "core/program/heidenhain/drilling_cycles.h"
#include "core/program/heidenhain/motion_words.h"
#include "core/program/heidenhain/q_parameters.h"
#include "core/program/heidenhain/transformations.h"
#include "core/program/reader.h"

namespace feedscope {

/// What the two languages of the control have in common: contours, tools, cycles, labels, calls, parameters.
/// Each language turns its lines into calls of what follows.
class HeidenhainCore : public Reader {
 protected:
  HeidenhainCore(std::shared_ptr<const SourceText> source, const ReadOptions& options, Progress* progress);

  // Text: heidenhain_core.cpp

  /// One statement, comments left out, that may have come from several lines. ReadFault is caught.
  virtual void run_statement(std::string_view statement) = 0;
  /// The label that a line sets, as label() reads it; empty for none and for the end of a subprogram.
  virtual std::string label_on(std::string_view line) = 0;
  /// What the called programs must be written in too.
  virtual Dialect dialect() const = 0;
  /// Throws ReadFault "unread-word" about the rest of the statement.
  [[noreturn]] static void throw_unread_words(Scanner& scanner, std::string_view where);

  /// As Reader's, also where a statement came from several lines.
  template <typename MakeText>
  void report(Severity severity, std::string_view code, int detail, std::uint32_t column, MakeText&& text) {
    log().add(severity, code, detail, spot(column), text);
  }
  DiagnosticLog::Place spot(std::uint32_t column) const;
  BlockPlace contour_place(std::uint32_t column, std::uint8_t axes) const;

  /// Lengths and feeds as written, in mm and mm/s.
  double to_mm(double value) const { return value * unit_; }
  double to_feed(double value) const;
  void set_inch(bool inch);
  bool is_inch() const { return unit_ != 1; }
  QFormulas& formulas() { return formulas_; }
  QParameters& parameters() { return parameters_; }

  // Motion: heidenhain_motion.cpp

  enum class PathKind : std::uint8_t {
    line,               ///< L, G0, G1
    center_arc,         ///< C: about the pole
    radius_arc,         ///< CR
    tangent_arc,        ///< CT, G6
    polar_line,         ///< LP, G10, G11
    polar_arc,          ///< CP, G12, G13: about the pole
    polar_tangent_arc,  ///< CTP, G16
  };
  void run_path(PathKind kind, const MotionWords& words);
  void set_pole(const MotionWords& words);
  void run_corner(bool rounding, double size, const MotionWords& words, std::uint32_t column);
  void run_approach(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column);
  /// The line before leads onto the contour by an arc of this radius [mm], with its own feed.
  void run_soft_approach(double radius, const MotionWords& words, std::uint32_t column);
  /// `curve_feed` is that of the part next to the contour; none: that of the words.
  void run_departure(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column,
                     const std::optional<ContourFeed>& curve_feed = std::nullopt);
  /// Of a block whose feed holds for it alone; none if it has none.
  std::optional<ContourFeed> feed_alone(const MotionWords& words);
  /// An M with the words that belong to it. Throws ReadFault.
  void m_word(Scanner& scanner, std::uint32_t column, MotionWords& words);
  /// Only M functions.
  void run_functions(const MotionWords& words);
  /// A word of A B C U V W.
  static void set_other_axis(char letter, double value, bool incremental, std::uint32_t column,
                             MotionWords& words);
  /// What is held back is written, and what follows is of this line.
  void end_contour(std::uint32_t column);
  /// [1/min]; 0: none yet.
  double spindle_speed() const { return spindle_speed_; }
  /// The working plane.
  Plane plane() const { return contour_.plane(); }

  // Tools and settings: heidenhain_settings.cpp

  struct ToolCall {
    std::optional<std::string> tool;
    std::optional<Plane> plane;   ///< across the tool axis
    std::optional<double> speed;  ///< [1/min]
    std::optional<double> feed;   ///< as written
    FeedWord feed_word = FeedWord::value;
    std::uint32_t feed_column = 0;
    double radius_excess = 0;  ///< DR [mm]
  };
  /// A tool's number or name, as a key; none if none stands here.
  std::optional<std::string> tool_name(Scanner& scanner);
  void define_tool(const std::string& tool, double radius) { defined_radii_.set(tool, radius); }
  void call_tool(const ToolCall& call);
  void set_blank_corner(bool upper, const std::array<OptionalWord, 3>& corner, std::uint32_t column);
  Transformations& transformations() { return transformations_; }
  /// A scaling factor as the control takes it. Throws ReadFault "scale-factor".
  static double checked_factor(double factor, std::uint32_t column);
  /// What the transformations are now is in force.
  void apply_transformations(std::uint32_t column);
  void set_tolerance(std::optional<double> tolerance, std::optional<double> orientation_tolerance,
                     std::uint32_t column);
  /// The working plane tilted against the coordinates in force so far; none: no longer.
  void set_tilt(const std::optional<CoordinateFrame>& tilt, std::uint32_t column);
  void shift_datum(const std::array<OptionalWord, 3>& to, std::uint32_t column);
  void dwell(double seconds, std::uint32_t column);
  void set_datum(std::string_view what, std::uint32_t column);
  /// A datum of the machine; shift, mirror, rotation and scaling end unless `keeps_transformations`.
  void set_preset(std::string_view what, bool keeps_transformations, std::uint32_t column);

  // Labels, calls, the end: heidenhain_flow.cpp

  /// A label's number, name in quotes or text parameter, as a key. Throws ReadFault.
  std::string label(Scanner& scanner);
  void call_label(const std::string& label, std::uint32_t column);
  void repeat_from_label(const std::string& label, double times, std::uint32_t column);
  void jump_to_label(const std::string& label, std::uint32_t column);
  void end_subprogram();
  void call_program(std::string_view written, std::uint32_t column);
  /// The called program returns, the main one ends.
  void end_of_program();

  // Parameters: heidenhain_functions.cpp

  /// "Q1 = ..." from the name on.
  void assign(Scanner& scanner);
  /// FN or D with its operands.
  struct FunctionCall {
    int number = 0;
    std::uint32_t column = 0;
    std::optional<QName> result;  ///< 0 to 8 and 13 have one
    std::array<double, 2> values{};
    std::string label;  ///< of the jumps 9 to 12
  };
  void run_function(const FunctionCall& call);
  /// FN 18 from "SYSREAD" on.
  void read_system_data(Scanner& scanner, std::uint32_t column);
  /// FN 14 and the functions that do not touch the path.
  void note_function(int number, std::uint32_t column);

  // Cycles: heidenhain_cycles.cpp

  /// The parameters stand as "Q200=2" from the scanner on.
  void define_cycle(int number, std::string_view title, Scanner& parameters, std::uint32_t column);
  void define_old_drilling(int number) { set_cycle({number, CycleKind::old_drilling, {}}); }
  /// The value of its line or P word number `part`, as written.
  void set_old_drilling(int number, int part, double value);
  void define_program_cycle(std::string_view program) {
    set_cycle({12, CycleKind::program, std::string(program)});
  }
  void leave_out_cycle(int number, std::string_view title, std::uint32_t column);
  /// GLOBAL DEF: what PREDEF stands for in the cycles that follow.
  void predefine(Scanner& parameters) { read_cycle_parameters(parameters, predefined_); }
  /// `surface_offset` raises the surface of a drilling cycle [mm].
  void call_cycle(std::uint32_t column, double surface_offset = 0);
  /// CYCL CALL POS.
  void call_cycle_at(const MotionWords& words, std::uint32_t column);
  /// PATTERN DEF: places of CYCL CALL PAT, along the tool axis offsets of the surface [mm].
  void set_pattern(std::vector<Vec3> places) { pattern_ = std::move(places); }
  void call_cycle_at_pattern(const MotionWords& words, std::uint32_t column);

 private:
  enum class CycleKind : std::uint8_t { none, drilling, old_drilling, program, left_out };
  struct Cycle {
    int number = 0;
    CycleKind kind = CycleKind::none;
    std::string program;
  };
  struct Frame {
    bool program = false;  ///< a program was called, not a label
    double unit = 1;
    QParameters::Locals locals;
  };
  /// It ends the calls of M89 too.
  void set_cycle(Cycle cycle) {
    cycle_ = std::move(cycle);
    modal_cycle_ = false;
  }
  using Labels = std::map<std::string, std::uint32_t, std::less<>>;

  void run_line(std::string_view line) override;
  void run_joined();
  void before_finish() override;
  void left_call() override;
  void run_out() override;

  double unset_parameter(const QName& name);
  void read_system_data(const QName& result, double group, double number, double index, std::uint32_t column);
  /// What FN 18 answers; none where only the machine knows.
  std::optional<double> system_data(double group, double number, double index);
  std::optional<double> number_of_tool() const;

  ContourElement element_of(const MotionWords& words, const Vec3& target) const;
  void add_path(PathKind kind, const MotionWords& words);
  void note_programmed_axes(const MotionWords& words);
  void add_radius_arc(ContourElement element, const MotionWords& words);
  void add_center_arc(ContourElement element, const MotionWords& words);
  void add_polar(PathKind kind, const MotionWords& words);
  void add_tangent_arc(ContourElement element);
  Vec3 target_of(const MotionWords& words) const;
  Vec3 polar_target(const MotionWords& words);
  /// Says which word of the block no motion of this kind has.
  void check_words(PathKind kind, const MotionWords& words);
  void move_other_axes(const MotionWords& words);
  int turn_of(const MotionWords& words);
  bool has_pole(std::uint32_t column);
  void apply_feed(const MotionWords& words);
  void apply_side(const MotionWords& words);
  ContourFeed feed_of(const MotionWords& words) const;
  void start_functions(const MotionWords& words);
  void finish_functions(const MotionWords& words, bool moved);
  void retract(const MotionWords& words);
  void run_spindle(int number, std::uint32_t column);
  bool goes_to_machine_position(const MotionWords& words);
  ApproachShape approach_shape(ApproachKind kind, const MotionWords& words, std::uint32_t column);
  void check_side(std::uint32_t column);
  void report_feed_value(const MotionWords& words);

  std::optional<std::uint32_t> line_of_label(const std::string& label, std::uint32_t column);
  const Labels& labels();
  bool enter(const std::shared_ptr<const SourceText>& text, std::uint32_t line, bool program);

  void read_cycle_parameters(Scanner& scanner, QParameters& into);
  std::optional<Drilling> drilling_words(std::uint32_t column);
  void report_drilling_fault(DrillingFault fault, std::uint32_t column);
  std::vector<Vec2> pattern_places(int number, std::uint32_t column);
  void run_pattern(int number, std::uint32_t column);
  Drilling pattern_heights() const;
  DrillingFault drill_in_pattern(const Drilling& words, const DrillingPlace& place);

  ContourWriter contour_;
  QParameters parameters_;
  QFormulas formulas_;
  Transformations transformations_;

  std::string joined_;  ///< statement that goes over several lines
  struct Part {
    std::size_t start = 0;  ///< in joined_
    std::uint32_t line = 0;
  };
  std::vector<Part> parts_;
  bool comment_goes_on_ = false;

  double unit_ = 1;  ///< mm a written length
  ContourFeed feed_;
  bool last_rapid_ = false;
  double tool_feed_ = 0;  ///< of the last tool call, as written
  FeedWord tool_feed_word_ = FeedWord::value;
  double spindle_speed_ = 0;  ///< [1/min]
  int side_ = 0;
  bool revolution_feed_ = false;  ///< M136
  std::optional<Vec3> pole_;
  Plane pole_plane_ = Plane::xy;
  double last_polar_angle_ = 0;
  int last_turn_ = 0;
  bool modal_cycle_ = false;              ///< M89
  std::uint8_t programmed_axes_ = 0;      ///< X Y Z that had an absolute coordinate, a bit each
  std::array<double, 6> other_places_{};  ///< of A B C U V W as written

  CutterRadii defined_radii_;  ///< by TOOL DEF
  std::string tool_;
  std::optional<double> tool_radius_;
  std::optional<Vec3> blank_;

  std::vector<Frame> frames_;
  std::map<const SourceText*, Labels> labels_;
  std::map<std::tuple<std::size_t, const SourceText*, std::uint32_t>, double> repeats_left_;

  QParameters predefined_;
  std::vector<Vec3> pattern_;
  Cycle cycle_;
  OldDrilling old_drilling_;
};

}  // namespace feedscope
