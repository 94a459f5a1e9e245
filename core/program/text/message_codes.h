#pragma once

#include <array>
#include <string>
#include <string_view>

namespace feedscope {

/// One kind of message about programs, for the handbook's page of messages.
struct MessageCodeInfo {
  std::string_view code;      ///< stable short name
  std::string_view severity;  ///< possible severities
  std::string_view example;   ///< cause of the message, in Markdown
  std::string_view group;     ///< heading of the page
};

/// Every code that readers report, in the order of the page.
constexpr auto message_codes = std::to_array<MessageCodeInfo>({
    {"empty-program", "error", "a file of comments", "The text as a whole"},
    {"no-motion", "warning", "`M3 S100` alone", "The text as a whole"},
    {"unit-assumed", "warning",
     "motion before `G20`, `G21`, `G70`, `G71` or `BEGIN PGM A MM`, without `--unit`: mm is used",
     "The text as a whole"},
    {"unsupported-control", "error", "a program for Okuma", "The text as a whole"},
    {"turning-program", "warning", "`G50 S3000`", "The text as a whole"},
    {"text-after-end", "info", "`G0 X2` after `M30`", "The text as a whole"},
    {"chord-error", "info", "a curve as a hundred short lines", "The text as a whole"},
    {"beyond-machines", "error", "`G0 X999999999`, a radius of 7 km, `F0.0000001`", "The text as a whole"},
    {"run-limit", "error", "a loop that does not end; holes with millions of infeeds", "The text as a whole"},
    {"call-depth", "error", "a subprogram that calls itself without end", "The text as a whole"},
    {"tool-table", "info, warning", "radii from a tool table; a table that cannot be read",
     "The text as a whole"},
    {"malformed-number", "error", "`X1..2`, `X-`, `X1e5`", "Numbers, words and expressions"},
    {"number-range", "error", "`X2000000000`", "Numbers, words and expressions"},
    {"decimal-point", "warning", "`X25000`, `G4 X1500`, probably without its decimal point",
     "Numbers, words and expressions"},
    {"unclosed-comment", "error", "`G0 X1 (tool 3`", "Numbers, words and expressions"},
    {"unknown-character", "error", "`G1 !X1`", "Numbers, words and expressions"},
    {"duplicate-word", "error", "`X1 Y2 X3`", "Numbers, words and expressions"},
    {"unused-word", "warning, info", "`K4` without an arc", "Numbers, words and expressions"},
    {"unread-word", "error", "`L X+1 K5`, `FT5` (Heidenhain)", "Numbers, words and expressions"},
    {"unread-statement", "error, warning, info", "`CYCLE832(0.01)` in ISO, `FL X+5`, `TCH PROBE`",
     "Numbers, words and expressions"},
    {"unknown-statement", "error", "`G1 X5` in a conversational program", "Numbers, words and expressions"},
    {"syntax", "error", "`X2 ?`, a bracket that is not closed (Sinumerik)", "Numbers, words and expressions"},
    {"expression", "error", "`X[1+`, `Q1 = ( 1`", "Numbers, words and expressions"},
    {"expression-value", "error", "`X[1/0]`, `Q1 = 1 / 0`", "Numbers, words and expressions"},
    {"variable", "error", "`X#1.5`, `#0=3`", "Numbers, words and expressions"},
    {"unset-variable", "error, warning", "`X#<depth>`, `X#500` before it is set",
     "Numbers, words and expressions"},
    {"control-variable", "warning", "`X#5021`, a value of the control", "Numbers, words and expressions"},
    {"unset-parameter", "warning, info", "`X=R5` before `R5=`, `X+Q5` before `Q5 =`",
     "Numbers, words and expressions"},
    {"parameter-number", "error", "`Q2000`", "Numbers, words and expressions"},
    {"unknown-name", "error", "`SPEED=5` without DEF", "Numbers, words and expressions"},
    {"system-variable", "error, warning, info", "`X=$AA_IM[X]`, `$P_BFRAME=`",
     "Numbers, words and expressions"},
    {"system-data", "warning", "`FN 18: SYSREAD Q1 = ID50 NR2`", "Numbers, words and expressions"},
    {"definition", "error", "`DEF LIST VALS`", "Numbers, words and expressions"},
    {"array-size", "error", "`DEF REAL A[0]`", "Numbers, words and expressions"},
    {"array-index", "error", "`A[9]` of an array of 5", "Numbers, words and expressions"},
    {"macro", "error", "`DEFINE HOME`", "Numbers, words and expressions"},
    {"alarm", "error", "`#3000=1`: the program ends there", "Jumps, loops, calls"},
    {"program-error", "error", "`FN 14: ERROR = 1000` that is reached", "Jumps, loops, calls"},
    {"flow-pair", "error", "`o5 if [1]` without `o5 endif`, `END1` without `DO1`", "Jumps, loops, calls"},
    {"control-structure", "error", "`IF` without `ENDIF`", "Jumps, loops, calls"},
    {"jump-target", "error", "`GOTO 7`, `M99 P7` without a block N7", "Jumps, loops, calls"},
    {"unknown-label", "error", "`GOTOF DONE` without a label `DONE:` after it", "Jumps, loops, calls"},
    {"label", "error, warning", "`LBL 1.5`; a label that is defined twice", "Jumps, loops, calls"},
    {"label-missing", "error", "`CALL LBL 9` without `LBL 9`", "Jumps, loops, calls"},
    {"repeat-count", "error", "`M98 P1 L-1`", "Jumps, loops, calls"},
    {"endless-program", "info", "`M99 P1` at the end of a main program", "Jumps, loops, calls"},
    {"subprogram", "error", "`M98 P1000`, `CALL PGM PART2.H` that was not found", "Jumps, loops, calls"},
    {"subprogram-missing", "error", "`SHAPE_1(5)` that was not found", "Jumps, loops, calls"},
    {"subprogram-name", "error", "`L=7`", "Jumps, loops, calls"},
    {"output-statement", "info", "`DPRNT[X#1[53]]`", "Jumps, loops, calls"},
    {"control-command", "info", "`$H` (grbl)", "Jumps, loops, calls"},
    {"synchronized-action", "info", "`WHEN ... DO`", "Jumps, loops, calls"},
    {"unknown-g", "error", "`G77.7`", "Words that are not supported"},
    {"unread-g", "error, warning, info", "`G33`, `G43.4`; `G5.1 Q2`; `G43`", "Words that are not supported"},
    {"unread-m", "warning, info", "`M97`; `M128` (Heidenhain)", "Words that are not supported"},
    {"unread-function", "error, warning, info", "`TRACYL`, `FN 28`; `TRAORI`, `FN 16`",
     "Words that are not supported"},
    {"unread-cycle", "error, info", "`POCKET3(...)`, cycle 251; cycle 14, which does not move",
     "Words that are not supported"},
    {"unread-axis", "error, warning", "`G1 X5 B90` from another angle", "Words that are not supported"},
    {"unread-vector", "info", "`LN ... NX NY NZ`", "Words that are not supported"},
    {"conflicting-g", "error", "`G0 G1 X5`", "Words that are not supported"},
    {"too-many-g", "error", "more than eight G words of coordinates in a block",
     "Words that are not supported"},
    {"modal-state", "error", "`M72` without `M70`", "Words that are not supported"},
    {"work-offset", "warning", "`G55` after motion in `G54`, cycle 247 after a motion", "Coordinates"},
    {"offset-number", "error", "`G10 L2 P12 X5`", "Coordinates"},
    {"reference-point", "warning", "`G28`, `G30`", "Coordinates"},
    {"machine-position", "warning",
     "`G53 Z0`, `SUPA Z0`, `M91`: neither drawn nor timed unless the machine file gives its positions",
     "Coordinates"},
    {"unknown-position", "warning", "`G28 G91 Z0`, then a feed move before Z is programmed", "Coordinates"},
    {"rotation-angle", "error", "`G68 X0 Y0`", "Coordinates"},
    {"scale-factor", "error", "`G51 P0`, `SCALE X0`", "Coordinates"},
    {"frame-increment", "info", "`TRANS X4`, then `G91 X1`", "Coordinates"},
    {"frame-range", "error", "`ASCALE X1000` in a long loop", "Coordinates"},
    {"frame-value", "error", "`$P_PFRAME=CROTS(X,9)`", "Coordinates"},
    {"swivel", "error", "`CYCLE800` in an unsupported mode", "Coordinates"},
    {"swivel-retract", "warning, info", "`CYCLE800(1, ...)`, `PLANE ... MB MAX`, `MOVE DIST50`",
     "Coordinates"},
    {"tilted-plane", "warning", "`G68.2`", "Coordinates"},
    {"plane", "error", "`PLANE VECTOR` with parallel vectors", "Coordinates"},
    {"rotary-way", "info", "`C350`, then `C10`: 340 degrees back, on a machine with the axis C",
     "Coordinates"},
    {"rotary-position", "info",
     "`PLANE ... STAY`, `CYCLE800` without a direction, on a machine with rotary axes", "Coordinates"},
    {"rotary-feed", "warning, info", "`G1 X5 A10`, on a machine with the axis A", "Coordinates"},
    {"rotary-travel", "error", "`A120` on a machine whose axis A ends at 50 degrees", "Coordinates"},
    {"rotary-direction", "error", "a tilted plane that no position of the rotary axes gives", "Coordinates"},
    {"tilt-angles", "warning", "`CYCL DEF 19.1 A+90 C+30`", "Coordinates"},
    {"tilted-shift", "warning", "cycle 7 again in a plane that was tilted about a shifted datum",
     "Coordinates"},
    {"polar-words", "error", "`@5 X3`", "Coordinates"},
    {"pole", "error", "`LP PR+5 PA+0` before `CC`", "Coordinates"},
    {"blank-form", "warning", "an upper corner below the lower one", "Coordinates"},
    {"motion-mode", "warning, error", "`X1` before any `G0` to `G3`, after `G80` (LinuxCNC, grbl)",
     "Motion, feed, dwell"},
    {"feed-missing", "error", "`G1 X5` before any F; reported once", "Motion, feed, dwell"},
    {"feed-value", "error, warning", "`F0`, `F-5`, `G20 F60` (LinuxCNC)", "Motion, feed, dwell"},
    {"tooth-count", "warning", "`FZ0.1`: one tooth is assumed", "Motion, feed, dwell"},
    {"dwell-time", "error", "`G4`, `G4 P-1`", "Motion, feed, dwell"},
    {"dwell-unit", "info", "`G4 P2`", "Motion, feed, dwell"},
    {"positioning-axis", "error, info", "`G1 Y3 POS[X]=5`; `POS[X]=5` without `FA`", "Motion, feed, dwell"},
    {"thread", "info", "`G33 Z-5 K1`", "Motion, feed, dwell"},
    {"arc-center", "error", "`G2 X20`, `G2 X20 I5 R5`", "Arcs, curves, corners"},
    {"arc-centers", "warning", "a whole program whose I J K fit as positions only", "Arcs, curves, corners"},
    {"arc-radius", "error", "`G2 X20 R4` from X10, ends on two radii", "Arcs, curves, corners"},
    {"arc-ends", "error", "`G2 R5`", "Arcs, curves, corners"},
    {"arc-turns", "error", "`G2 I5 P0`", "Arcs, curves, corners"},
    {"arc-angle", "error", "`AR=400`", "Arcs, curves, corners"},
    {"arc-middle", "error", "`CIP` points on one line", "Arcs, curves, corners"},
    {"arc-tangent", "error", "`CT` without a preceding motion", "Arcs, curves, corners"},
    {"arc-direction", "error", "`C X+5 Y+5` without DR", "Arcs, curves, corners"},
    {"tangent-arc", "error", "`CT` after a motion along the tool axis", "Arcs, curves, corners"},
    {"line-angle", "error", "`X5 ANG=90`", "Arcs, curves, corners"},
    {"scaled-arc", "info", "`G51 X0 Y0 I2 J1` before an arc: it becomes lines", "Arcs, curves, corners"},
    {"spline-words", "error", "`G5` without P Q, `G5.2` without `G5.3`", "Arcs, curves, corners"},
    {"spline-weight", "error", "`PW=0`", "Arcs, curves, corners"},
    {"polynomial", "error", "more than five coefficients", "Arcs, curves, corners"},
    {"curve-as-arcs", "info", "`G5 X9 I1 J1 P1 Q1`, `BSPLINE`", "Arcs, curves, corners"},
    {"curve-as-lines", "info", "a curve under cutter compensation, or at a rounded corner",
     "Arcs, curves, corners"},
    {"corner", "error, warning", "a rounding or chamfer that does not fit; one that is reduced",
     "Arcs, curves, corners"},
    {"path-tolerance", "error, warning", "`G64 P-1`; `G64 P0.0000001`", "Arcs, curves, corners"},
    {"machining-mode", "info", "`CYCLE832(0.01,_ROUGH)`, `HSC-MODE:1`, `G187 P1`, `G5.1 Q1 R5`",
     "Arcs, curves, corners"},
    {"path-value", "error, warning", "`ADIS=-1`; `CYCLE832(0.01)`", "Arcs, curves, corners"},
    {"path-controls", "error", "more than 65536 different path control settings", "Arcs, curves, corners"},
    {"spindle-speeds", "warning", "more than 65535 different values of `S`", "Arcs, curves, corners"},
    {"tolerance", "error, warning", "cycle 32 with `T-1`; with `T0.0000001`", "Arcs, curves, corners"},
    {"tool-radius", "error", "`G41` or `RL` with a tool whose radius is not known", "Tools and compensation"},
    {"compensation-gouge", "error", "a tool radius of 5 mm in an inside arc of 3 mm",
     "Tools and compensation"},
    {"compensation-entry", "error", "compensation that begins on an arc", "Tools and compensation"},
    {"compensation-exit", "error", "compensation that ends on an arc", "Tools and compensation"},
    {"compensation-plane", "error", "another plane while compensation is active", "Tools and compensation"},
    {"approach", "error", "`APPR` without a contour after it", "Tools and compensation"},
    {"approach-side", "warning", "`APPR CT` with R0: the left side is assumed", "Tools and compensation"},
    {"cycle-words", "error", "`G81` without Z or R, `G83` without Q, `K-1`", "Cycles"},
    {"cycle-aside", "info", "`G76 Q1`, `G87 Q1`", "Cycles"},
    {"cycle-call", "error", "`M99` before any cycle", "Cycles"},
    {"cycle-parameter", "error", "a cycle without Q201", "Cycles"},
    {"cycle-value", "error, warning, info", "a depth above the surface; Q395=1; Q365=1", "Cycles"},
    {"pattern", "error", "`PATTERN DEF HEX1 (...)`, `NUM0`", "Cycles"},
    {"hole-count", "error", "`HOLES2(...,0)`", "Cycles"},
    {"hole-depth", "error", "`CYCLE81(10,0,2,-5,,0,10)`", "Cycles"},
});

/// The code of a message, checked by the compiler: it is one of message_codes.
class MessageCode {
 public:
  consteval MessageCode(const char* code) : text_(find(code)) {}  // NOLINT(*-explicit-*): literals are codes

  constexpr std::string_view text() const { return text_; }
  constexpr bool operator==(const MessageCode&) const = default;

 private:
  static consteval std::string_view find(std::string_view code) {
    for (const MessageCodeInfo& info : message_codes) {
      if (info.code == code) {
        return info.code;
      }
    }
    throw "not one of message_codes: add it there";
  }

  std::string_view text_;
};

/// All codes in Markdown: a third-level heading and a list for each group.
std::string message_code_lists();

}  // namespace feedscope
