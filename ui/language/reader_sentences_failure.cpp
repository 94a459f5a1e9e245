#include "ui/language/reader_sentences.h"

#include <QtGlobal>
#include <array>

namespace feedscope::ui {

namespace {

constexpr std::array failure_patterns{
    // Files and places in them (machine/file_text, machine/config_file).
    QT_TRANSLATE_NOOP("core", "'%1' is a folder; give a %2"),
    QT_TRANSLATE_NOOP("core", "cannot read %1 '%2': %3"),
    QT_TRANSLATE_NOOP("core", "'%1' is larger than %2 MiB and cannot be a %3"),
    QT_TRANSLATE_NOOP("core", "machine file"),
    QT_TRANSLATE_NOOP("core", "load file"),
    QT_TRANSLATE_NOOP("core", "file of materials"),
    QT_TRANSLATE_NOOP("core", "lesson"),
    QT_TRANSLATE_NOOP("core", "configuration of a control"),
    QT_TRANSLATE_NOOP("core", "configuration"),
    QT_TRANSLATE_NOOP("core", "table of section times"),
    QT_TRANSLATE_NOOP("core", "column specification"),
    QT_TRANSLATE_NOOP("core", "unknown key '%1' in %2; %3"),
    QT_TRANSLATE_NOOP("core", "known: %1"),
    QT_TRANSLATE_NOOP("core", "key '%1' is missing in %2"),
    QT_TRANSLATE_NOOP("core", "'%1' in %2 must be a table"),
    QT_TRANSLATE_NOOP("core", "'%1' in %2 must be a text in quotes"),
    QT_TRANSLATE_NOOP("core", "the file"),
    QT_TRANSLATE_NOOP("core", "not valid TOML: %1"),
    QT_TRANSLATE_NOOP("core", "No such file or directory"),
    QT_TRANSLATE_NOOP("core", "Permission denied"),
    QT_TRANSLATE_NOOP("core", "Is a directory"),
    QT_TRANSLATE_NOOP("core", "No space left on device"),
    // Machines (machine/*, models/control_model).
    QT_TRANSLATE_NOOP("core", "cannot read machine folder '%1': %2"),
    QT_TRANSLATE_NOOP("core", "unknown machine '%1': neither a machine id nor a file; %2"),
    QT_TRANSLATE_NOOP("core", "ids: %1"),
    QT_TRANSLATE_NOOP("core", "machine '%1': %2"),
    QT_TRANSLATE_NOOP("core",
                      "machine '%1': axis %2 moves in this program, but one of its limits is %3; every limit "
                      "of an axis that moves must be above 0"),
    QT_TRANSLATE_NOOP(
        "core",
        "axis %1 has values of a drive but no position gain; give %2.kv in 1/s, or remove the others"),
    QT_TRANSLATE_NOOP(
        "core", "axis %1 has a friction spike but no time in which it decays; give %2.friction_time in ms"),
    QT_TRANSLATE_NOOP("core",
                      "axis %1 is a rotary axis, and the file does not say where it is; add [kinematics] "
                      "with its chain, and %2 with direction and point"),
    QT_TRANSLATE_NOOP("core", "%1 has no limits; add [axes.%2]"),
    QT_TRANSLATE_NOOP("core",
                      "the chain '%1' %2; name X, Y, Z and the rotary axes once each from the part to the "
                      "tool, with the word frame between those that carry the part and those that carry the "
                      "tool, as in \"C A Y frame X Z\""),
    QT_TRANSLATE_NOOP("core", "the travel of axis %1 is empty, from %2 to %3 degrees"),
    QT_TRANSLATE_NOOP(
        "core", "%1 is not a work offset; write it as programs name it, such as G55, \"G54.1 P3\" or G505"),
    QT_TRANSLATE_NOOP("core", "%1 is given twice; remove one"),
    QT_TRANSLATE_NOOP("core", "%1 must have one of source = \"paper, table\" and assumed = \"reason\""),
    QT_TRANSLATE_NOOP("core",
                      "%1 needs a source: write { value = ..., source = \"paper, table\" } or { value = ..., "
                      "assumed = \"reason\" }"),
    QT_TRANSLATE_NOOP("core", "value of %1 must be a number"),
    QT_TRANSLATE_NOOP("core", "value of %1 must be a number or text"),
    QT_TRANSLATE_NOOP("core", "%1 of %2 must be a number"),
    QT_TRANSLATE_NOOP("core", "unknown axis '%1'; the axes are %2"),
    QT_TRANSLATE_NOOP("core", "unknown limit '%1' of axis %2; %3"),
    QT_TRANSLATE_NOOP("core", "the limits are %1"),
    QT_TRANSLATE_NOOP("core", "unknown model '%1'; known models: %2"),
    QT_TRANSLATE_NOOP("core", "unknown model '%1'; did you mean '%2'? known models: %3"),
    // Numbers and settings (base/typed_number, machine/settings).
    QT_TRANSLATE_NOOP("core", "%1 = '%2' is not a number; it must be %3"),
    QT_TRANSLATE_NOOP("core", "%1 = '%2': %3"),
    QT_TRANSLATE_NOOP("core", "%1 = '%2' is text; it must be a number %3"),
    QT_TRANSLATE_NOOP("core", "unknown unit '%1'; write the number in one of: %2"),
    QT_TRANSLATE_NOOP("core", "setting '%1' has no value"),
    QT_TRANSLATE_NOOP("core", "a number has one decimal separator and no thousands separators; write %1"),
    QT_TRANSLATE_NOOP("core", "the comma could be a decimal or a thousands separator; write %1 or %2"),
    // Traces (trace/*).
    QT_TRANSLATE_NOOP("core", "'%1' is a folder; give a trace"),
    QT_TRANSLATE_NOOP("core", "cannot read trace '%1': %2"),
    QT_TRANSLATE_NOOP("core", "'%1' is written in UTF-16; save it as UTF-8"),
    QT_TRANSLATE_NOOP("core", "%1:%2: the line is longer than 1 MiB; this is not a table of samples"),
    QT_TRANSLATE_NOOP("core",
                      "'%1' has no column that is known as the position of X, Y or Z; it has %2; say which, "
                      "as --columns x=2:mm,y=3:mm"),
    QT_TRANSLATE_NOOP("core", "no title of a column says which are the positions of X, Y and Z"),
    QT_TRANSLATE_NOOP("core", "the columns have no titles"),
    QT_TRANSLATE_NOOP("core",
                      "'%1' has no signal that is known as the position of X, Y or Z; it has %2; say which, "
                      "as --columns x=1:mm,y=2:mm"),
    QT_TRANSLATE_NOOP("core", "%1:%2: no samples follow the head of the TwinCAT Scope export"),
    QT_TRANSLATE_NOOP("core", "'%1' has no record of a SINUMERIK trace"),
    QT_TRANSLATE_NOOP("core", "%1:%2: %3; this is no whole XML file"),
    QT_TRANSLATE_NOOP("core", "%1:%2: the trace has more than %3 million samples"),
    QT_TRANSLATE_NOOP("core",
                      "'%1' has no position of X, Y or Z; name their columns, as --columns x=2:mm,y=3:mm"),
    QT_TRANSLATE_NOOP("core", "'%1' has too few samples whose times rise: %2; a trace has at least %3"),
    QT_TRANSLATE_NOOP("core", "'%1' has no column '%2' for %3; %4"),
    QT_TRANSLATE_NOOP("core", "it has %1 columns without names"),
    QT_TRANSLATE_NOOP("core", "it has %1"),
    QT_TRANSLATE_NOOP("core",
                      "'%1' is no trace: no row of numbers in its first %2 lines; known are LinuxCNC "
                      "halsampler, SINUMERIK trace (XML), TwinCAT Scope (text) and tables of samples"),
    QT_TRANSLATE_NOOP("core", "column specification: %1"),
    QT_TRANSLATE_NOOP("core", "%1=%2 must be a number from %3 to %4"),
    QT_TRANSLATE_NOOP("core", "separator=%1 must be tab, comma, semicolon or blank"),
    QT_TRANSLATE_NOOP("core", "decimal=%1 must be point or comma"),
    QT_TRANSLATE_NOOP("core", "%1= needs the number or the name of a column, such as %2=2"),
    QT_TRANSLATE_NOOP("core", "unit '%1' of %2 is not known; known: %3"),
    QT_TRANSLATE_NOOP("core", "unknown key '%1'; %2"),
    QT_TRANSLATE_NOOP("core", "'%1' is not KEY=VALUE"),
    QT_TRANSLATE_NOOP(
        "core",
        "'%1' is no preset of columns; known: %2; or write a specification such as time=1:ms,x=2:mm,y=3:mm"),
    // Cutting load (load/*).
    QT_TRANSLATE_NOOP("core",
                      "the load file has an operation for tool %1, but the program changes to no tool; omit "
                      "'tool', so that the operation applies to all motions"),
    QT_TRANSLATE_NOOP("core",
                      "the load file has an operation for tool %1, which the program never changes to; %2"),
    QT_TRANSLATE_NOOP("core", "its tools are %1"),
    QT_TRANSLATE_NOOP("core", "did you mean tool %1?"),
    QT_TRANSLATE_NOOP(
        "core",
        "the load file has an operation for lines %1-%2, but the program has %3 lines; correct the range"),
    QT_TRANSLATE_NOOP("core", "operation of %1: %2"),
    QT_TRANSLATE_NOOP("core", "all tools"),
    QT_TRANSLATE_NOOP("core", "all tools, lines %1"),
    QT_TRANSLATE_NOOP("core", "tool %1"),
    QT_TRANSLATE_NOOP("core", "tool %1, lines %2"),
    QT_TRANSLATE_NOOP("core", "material '%1' is not known; %2, or add a [[material]] with its coefficients"),
    QT_TRANSLATE_NOOP("core", "use one such as '%1'"),
    QT_TRANSLATE_NOOP("core",
                      "ae_mm %1 is larger than diameter_mm %2; a tool is engaged over its diameter at most: "
                      "lower ae_mm, %3 is a full slot"),
    QT_TRANSLATE_NOOP("core", "lines %1-%2 is no range; write FIRST-LAST, counted from 1"),
    QT_TRANSLATE_NOOP("core",
                      "min_chip_um %1 is not below max_chip_um %2; every chip would be out of bounds"),
    QT_TRANSLATE_NOOP("core",
                      "operations %1 (%2) and %3 (%4) apply to the same motions; remove one, or give each "
                      "its own tool or lines"),
    QT_TRANSLATE_NOOP("core", "%1 in %2 must be a number"),
    QT_TRANSLATE_NOOP("core", "'%1' must be tables; begin each with [[%2]]"),
    QT_TRANSLATE_NOOP(
        "core",
        "'lines' must be ranges of lines of the program in quotes, such as \"10-25\" or \"10-25, 40-52\""),
    QT_TRANSLATE_NOOP("core", "'tool' must be its number, or its name in quotes, as the program calls it"),
    QT_TRANSLATE_NOOP("core", "milling '%1' is not known; write \"up\" (conventional) or \"down\" (climb)"),
    QT_TRANSLATE_NOOP("core", "law '%1' is not known; write \"linear-edge\" or \"kienzle\""),
    QT_TRANSLATE_NOOP("core", "%1 has no tangential cutting force; %2 must be above 0"),
    QT_TRANSLATE_NOOP("core", "material '%1' is given twice; remove one or give it another id"),
    QT_TRANSLATE_NOOP("core", "load files of version %1 are not known; this program reads version %2"),
    QT_TRANSLATE_NOOP("core",
                      "the file has no operation; add an [[operation]] with tool, diameter_mm, teeth, "
                      "helix_deg, ae_mm, ap_mm, milling and material"),
    // Circular tests, studies, runs (analysis/*, models/optimal).
    QT_TRANSLATE_NOOP("core",
                      "radius = %1 mm is out of bounds; it must be at least 0.001 mm and at most %2 mm"),
    QT_TRANSLATE_NOOP("core", "feed = %1 mm/min is out of bounds; it must be above 0 mm/min"),
    QT_TRANSLATE_NOOP("core", "sweep = %1 degrees is out of bounds; it must be above 0 and at most 360"),
    QT_TRANSLATE_NOOP(
        "core",
        "entry radius = %1 mm is out of bounds; it must be at least 0 mm and at most the radius of %2 mm"),
    QT_TRANSLATE_NOOP("core",
                      "sweep '%1': %2; write KEY=FROM:TO:logN, KEY=FROM:TO:linN or \"KEY=A;B;C\", such as "
                      "tolerance=0.005:0.1:log12"),
    QT_TRANSLATE_NOOP("core", "from %1 to %2 is not a range"),
    QT_TRANSLATE_NOOP("core", "equal ratios need ends above 0, not %1"),
    QT_TRANSLATE_NOOP("core", "%1 values; there must be 2 to %2"),
    QT_TRANSLATE_NOOP("core", "the sweeps need more than %1 runs; use fewer values"),
    QT_TRANSLATE_NOOP("core",
                      "setting path: the path of ward needs more than %1 curves to be approximated within %2 "
                      "mm, up to line %3; choose the path of another model"),
    // Identification (identification/*).
    QT_TRANSLATE_NOOP("core",
                      "%1 is told by set and actual positions of %2; no trace has both: record the actual "
                      "position too, and name it if need be, as --columns actual_%3=5:mm"),
    QT_TRANSLATE_NOOP("core", "%1 = %2 %3 is out of bounds; it must be from %4 to %5 %6"),
    QT_TRANSLATE_NOOP("core", "identification needs at least one trace"),
    // Sessions (ui/session).
    QT_TRANSLATE_NOOP("core", "cannot read session '%1': %2"),
    QT_TRANSLATE_NOOP("core", "cannot write session '%1': %2"),
    QT_TRANSLATE_NOOP("core", "cannot use session '%1': %2"),
    QT_TRANSLATE_NOOP("core", "'%1' is larger than 64 MiB and cannot be a session"),
    QT_TRANSLATE_NOOP("core", "'%1' is not a session: %2 (%3)"),
    QT_TRANSLATE_NOOP("core", "it is not a Feedscope session: its \"format\" is not \"%1\""),
    QT_TRANSLATE_NOOP("core",
                      "it is of version %1, written by a newer Feedscope; this one reads up to version %2"),
    QT_TRANSLATE_NOOP("core", "its \"version\" is not a whole number from 1 to %1"),
    QT_TRANSLATE_NOOP("core", "it names no program: \"program\" has no \"file\""),
    QT_TRANSLATE_NOOP("core", "it has no runs: \"runs\" is empty or missing"),
    // Pictures, films, sheets and reports (ui/report, ui/window).
    QT_TRANSLATE_NOOP("core", "cannot write '%1' as a picture; its name must end in .png, .svg or .pdf"),
    QT_TRANSLATE_NOOP("core", "cannot write '%1': %2"),
    QT_TRANSLATE_NOOP("core", "not everything could be written; is there room for it?"),
    QT_TRANSLATE_NOOP("core", "this build of Feedscope has no Theora video"),
    QT_TRANSLATE_NOOP("core", "the program does not move, so that there is nothing to film"),
    QT_TRANSLATE_NOOP("core",
                      "the film would begin at %1 s and end at %2 s; give --from a time before that of --to"),
    QT_TRANSLATE_NOOP("core", "the film would end at %1 s, but the run takes %2 s; use a smaller --to"),
    QT_TRANSLATE_NOOP("core",
                      "the film would have %1 frames, and at most %2 can be written; use --speed %3 or more, "
                      "a smaller --fps, or a shorter stretch by --from and --to"),
    QT_TRANSLATE_NOOP("core",
                      "a film of %1 x %2 units is too small; use a larger --size or a smaller --scale"),
    QT_TRANSLATE_NOOP("core",
                      "a film of %1 x %2 units is too small for the view and the charts; use a larger --size "
                      "or a smaller --scale"),
    QT_TRANSLATE_NOOP("core",
                      "charts of %1 x %2 units are too small; they need at least %3 x %4: use a larger "
                      "--size or a smaller --scale"),
    QT_TRANSLATE_NOOP("core",
                      "the 3D view would have %1 x %2 pixels, and each side may have 1 to %3; use a smaller "
                      "--size, --scale or --dpi"),
    QT_TRANSLATE_NOOP("core",
                      "a sheet of %1 x %2 units is too small; it needs at least %3 on its longer and %4 on "
                      "its shorter side: use a larger --size or a smaller --scale"),
    QT_TRANSLATE_NOOP("core", "cannot read the template '%1': %2"),
    QT_TRANSLATE_NOOP("core", "it has %1 bytes, and a template may have %2"),
    QT_TRANSLATE_NOOP("core", "%1: unknown placeholder %2; %3"),
    QT_TRANSLATE_NOOP("core", "did you mean %1?"),
    QT_TRANSLATE_NOOP("core", "%1: section %2 is not closed; write %3 after it"),
    QT_TRANSLATE_NOOP("core", "%1: %2 closes no section"),
    QT_TRANSLATE_NOOP("core", "%1: %2 closes no section; %3 is open"),
    QT_TRANSLATE_NOOP("core", "%1: '{{' without '}}'"),
    QT_TRANSLATE_NOOP("core",
                      "machine '%1' has no rotary axes to draw; choose a machine with [kinematics], such as "
                      "five-axis-table-ac"),
    QT_TRANSLATE_NOOP("core", "picture '%1' cannot be read: %2"),
    QT_TRANSLATE_NOOP("core", "picture '%1' has %2 bytes, and a picture may have %3"),
    QT_TRANSLATE_NOOP("core",
                      "picture '%1' is not a picture; PNG, JPEG, SVG and other formats of Qt are supported"),
};

}  // namespace

std::span<const char* const> failure_sentences() {
  return failure_patterns;
}

}  // namespace feedscope::ui
