#include "ui/language/reader_sentences.h"

#include <QtGlobal>
#include <array>

namespace feedscope::ui {

namespace {

constexpr std::array import_patterns{
    // Fanuc, Heidenhain, Sinumerik.
    QT_TRANSLATE_NOOP("core", "there is no model of a Fanuc: that of another control runs its limits"),
    QT_TRANSLATE_NOOP("core", "'%1' is not a parameter; it is skipped"),
    QT_TRANSLATE_NOOP("core",
                      "the machine measures in inches (1001, bit 0), in which parameters are not imported; "
                      "all limits are assumed"),
    QT_TRANSLATE_NOOP("core", "write its limits into a machine file"),
    QT_TRANSLATE_NOOP("core", "which axes X, Y and Z are is not told; the first three are assumed"),
    QT_TRANSLATE_NOOP("core", "add parameter 1020"),
    QT_TRANSLATE_NOOP("core", "there is no linear axis %1; its limits are assumed"),
    QT_TRANSLATE_NOOP("core", "%1 is the cutting feed without look-ahead control; that with it, %2, is used"),
    QT_TRANSLATE_NOOP("core", "%1 (%2) is not modelled"),
    QT_TRANSLATE_NOOP("core", "time constant of rapids"),
    QT_TRANSLATE_NOOP("core", "time constant of cutting feeds after interpolation"),
    QT_TRANSLATE_NOOP("core", "acceleration of rapids"),
    QT_TRANSLATE_NOOP("core", "time in which the acceleration of rapids is reached"),
    QT_TRANSLATE_NOOP("core", "feed below which arcs do not slow down"),
    QT_TRANSLATE_NOOP("core", "acceleration on arcs"),
    QT_TRANSLATE_NOOP("core", "acceleration under look-ahead control"),
    QT_TRANSLATE_NOOP("core", "time constant after interpolation under look-ahead control"),
    QT_TRANSLATE_NOOP("core", "difference of feeds that is passed at corners without slowing down"),
    QT_TRANSLATE_NOOP("core", "change of acceleration that is passed without slowing down"),
    QT_TRANSLATE_NOOP("core", "indices 0, 1 and 2 are taken as X, Y and Z"),
    QT_TRANSLATE_NOOP("core", "exchange the axes in the machine file where that is not so"),
    QT_TRANSLATE_NOOP("core",
                      "the acceleration along the path, %1 m/s2, is not modelled: those of the axes hold"),
    QT_TRANSLATE_NOOP("core", "'%1' is not a machine parameter; it is skipped"),
    QT_TRANSLATE_NOOP(
        "core", "the basic system is inch, in which machine data are not imported; all limits are assumed"),
    QT_TRANSLATE_NOOP("core", "export the machine data with MD10240 = 1"),
    QT_TRANSLATE_NOOP("core", "'%1' is no machine datum; skipped"),
    QT_TRANSLATE_NOOP("core", "machine axis %1 would be %2 but is a rotary axis; its limits are assumed"),
    QT_TRANSLATE_NOOP("core", "which machine axes X, Y and Z are is not told; AX1, AX2 and AX3 are assumed"),
    QT_TRANSLATE_NOOP("core", "add MD20050 to MD20080 of the channel"),
    QT_TRANSLATE_NOOP("core", "%1 holds with %2; the value of DYNNORM, %3, is used"),
    QT_TRANSLATE_NOOP("core", "change it in the machine file for programs that finish with another mode"),
    // grbl, Marlin, Klipper.
    QT_TRANSLATE_NOOP("core", "'%1' is not a setting; it is skipped"),
    QT_TRANSLATE_NOOP("core", "the settings are numbered as in grbl 0.8 and before, which is not supported"),
    QT_TRANSLATE_NOOP("core", "update the control, or write its values into a machine file"),
    QT_TRANSLATE_NOOP(
        "core", "laser mode ($32 = 1) is not modelled: with a laser, changes of S do not stop the motion"),
    QT_TRANSLATE_NOOP("core", "a setting that no model here uses; skipped"),
    QT_TRANSLATE_NOOP("core", "axes other than X, Y and Z are not part of the simulation; skipped"),
    QT_TRANSLATE_NOOP("core", "%1, but %2 in %3; %4 is used"),
    QT_TRANSLATE_NOOP("core", "remove one of the two"),
    QT_TRANSLATE_NOOP("core",
                      "%1 is simulated as grbl with its values; what it does otherwise is not modelled"),
    QT_TRANSLATE_NOOP("core", "%1: '%2' is not a value; it is skipped"),
    QT_TRANSLATE_NOOP("core", "%1 exceeds %2 (%3); the lower one is used"),
    QT_TRANSLATE_NOOP("core",
                      "acceleration of travel moves %1 is not modelled: they have that of the others"),
    QT_TRANSLATE_NOOP("core",
                      "there is no model of %1: Klipper's runs its limits; its look-ahead has no end, while "
                      "that of the firmware has some 16 blocks, so that short blocks may take longer there"),
    QT_TRANSLATE_NOOP("core", "section [printer] is missing; its limits are assumed"),
    QT_TRANSLATE_NOOP("core", "import the file that Klipper itself reads, printer.cfg"),
    QT_TRANSLATE_NOOP("core", "%1 must be above %2: Klipper does not start with it"),
    QT_TRANSLATE_NOOP("core", "%1 exceeds %2 = %3 (%4): Klipper does not start with it"),
    QT_TRANSLATE_NOOP("core", "lower %1"),
    QT_TRANSLATE_NOOP(
        "core",
        "there is no section [gcode_arcs]: this Klipper does not know G2 and G3, while the model runs them"),
    QT_TRANSLATE_NOOP("core", "add [gcode_arcs], or let the CAM system write lines"),
    QT_TRANSLATE_NOOP("core",
                      "kinematics %1 are not modelled: limits hold along the path, and those of Z alone"),
    QT_TRANSLATE_NOOP("core", "[printer] %1 is not used here; skipped"),
    QT_TRANSLATE_NOOP("core", "did you mean '%1'?"),
    QT_TRANSLATE_NOOP(
        "core", "input shaping is not modelled: it smooths the motion and takes no longer on the whole"),
    // LinuxCNC.
    QT_TRANSLATE_NOOP("core", "[TRAJ] LINEAR_UNITS is missing; mm is assumed"),
    QT_TRANSLATE_NOOP("core", "write LINEAR_UNITS = mm or inch"),
    QT_TRANSLATE_NOOP("core", "LINEAR_UNITS = %1 is not a unit; mm is assumed"),
    QT_TRANSLATE_NOOP("core", "kinematics %1 is not modelled: X, Y and Z are treated as axes of their own"),
    QT_TRANSLATE_NOOP("core", "axis %1 is not part of the simulation; skipped"),
    QT_TRANSLATE_NOOP("core", "[%1] gives no %2; that of [%3] is assumed"),
    QT_TRANSLATE_NOOP("core", "write %1 into [%2]: LinuxCNC does not take it from the joint"),
    QT_TRANSLATE_NOOP("core", "%1 of axis %2 is missing; it is assumed"),
    QT_TRANSLATE_NOOP("core", "write %1 into [%2]"),
    QT_TRANSLATE_NOOP("core", "[%1] %2 = %3 exceeds [%4] %5 = %6 (%7); the planner uses %8"),
    QT_TRANSLATE_NOOP("core", "the joint cannot follow there: lower the limit of the axis"),
    QT_TRANSLATE_NOOP("core", "[TRAJ] %1 = %2 is not modelled; the model computes with %3"),
    QT_TRANSLATE_NOOP("core",
                      "P of G64 in the start-up code has no effect on blends in LinuxCNC 2.9; P%1 is used "
                      "for joining blocks alone"),
    QT_TRANSLATE_NOOP("core",
                      "write G64 P into the program, or set blend_tolerance_mm if your release takes it"),
    QT_TRANSLATE_NOOP("core", "[%1] %2 is not known; skipped"),
    QT_TRANSLATE_NOOP("core", "the offsets of %1 are not in the INI file; 0 is assumed"),
    QT_TRANSLATE_NOOP("core", "write them into the machine file: [kinematics], 'point' of each axis"),
    QT_TRANSLATE_NOOP("core", "%1 of axis %2 cannot be used: %3"),
    // All controls.
    QT_TRANSLATE_NOOP("core", "not used: %1"),
    QT_TRANSLATE_NOOP("core", "not used: %1 and %2 more"),
    QT_TRANSLATE_NOOP("core", "%1 cannot be used: %2"),
    QT_TRANSLATE_NOOP("core", "correct the file of the control; until then the value is assumed"),
    QT_TRANSLATE_NOOP("core", "%1: '%2' is not a number"),
    QT_TRANSLATE_NOOP("core", "%1 more notes are not listed"),
    QT_TRANSLATE_NOOP("core", "correct what is listed, and import the file once more"),
    QT_TRANSLATE_NOOP("core", "'%1' is not the configuration of a control that can be imported; known: %2"),
    QT_TRANSLATE_NOOP("core", "'%1' is neither a section nor a value; skipped"),
    QT_TRANSLATE_NOOP("core", "'%1' cannot be included: %2"),
    QT_TRANSLATE_NOOP("core", "values that stand there are missing here"),
    QT_TRANSLATE_NOOP("core", "no file is named"),
    QT_TRANSLATE_NOOP("core", "only the text itself is at hand"),
    QT_TRANSLATE_NOOP("core", "it includes itself"),
    QT_TRANSLATE_NOOP("core", "more than %1 files deep"),
    QT_TRANSLATE_NOOP("core", "more than %1 files"),
    QT_TRANSLATE_NOOP("core", "'' cannot be included: no file is named"),
    // Bounds of settings (machine/settings).
    QT_TRANSLATE_NOOP("core", "%1 = %2 is out of bounds; it must be %3"),
    QT_TRANSLATE_NOOP("core", "%1 = '%2' is not a valid choice; it must be one of: %3"),
    QT_TRANSLATE_NOOP("core", "at least %1 and at most %2"),
    QT_TRANSLATE_NOOP("core", "above %1 and at most %2"),
    QT_TRANSLATE_NOOP("core", "a whole number at least %1 and at most %2"),
    QT_TRANSLATE_NOOP("core", "0, or at least %1 and at most %2"),
    QT_TRANSLATE_NOOP("core", "at least %1"),
    QT_TRANSLATE_NOOP("core", "above %1"),
    QT_TRANSLATE_NOOP("core", "at most %1"),
};

}  // namespace

std::span<const char* const> import_sentences() {
  return import_patterns;
}

}  // namespace feedscope::ui
