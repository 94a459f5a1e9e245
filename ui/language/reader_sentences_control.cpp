#include "ui/language/reader_sentences.h"

#include <QtGlobal>
#include <array>

namespace feedscope::ui {

namespace {

constexpr std::array control_patterns{
    // grbl.
    QT_TRANSLATE_NOOP("core", "grbl rejects the line (error %1: %2: %3); it is not run"),
    QT_TRANSLATE_NOOP("core", "grbl rejects the line (error %1: %2); it is not run"),
    QT_TRANSLATE_NOOP("core", "a word must begin with a letter"),
    QT_TRANSLATE_NOOP("core", "a letter has no number"),
    QT_TRANSLATE_NOOP("core", "system commands are not part of a program"),
    QT_TRANSLATE_NOOP("core", "the value must not be negative"),
    QT_TRANSLATE_NOOP("core", "the line has more than 79 characters"),
    QT_TRANSLATE_NOOP("core", "the command is not supported"),
    QT_TRANSLATE_NOOP("core", "two commands of one group"),
    QT_TRANSLATE_NOOP("core", "no feed is given"),
    QT_TRANSLATE_NOOP("core", "the number of the command must be whole"),
    QT_TRANSLATE_NOOP("core", "two commands both use the axis words"),
    QT_TRANSLATE_NOOP("core", "a word is repeated"),
    QT_TRANSLATE_NOOP("core", "axis words of the plane are missing"),
    QT_TRANSLATE_NOOP("core", "a value is missing"),
    QT_TRANSLATE_NOOP("core", "the work offset does not exist"),
    QT_TRANSLATE_NOOP("core", "G53 needs G0 or G1"),
    QT_TRANSLATE_NOOP("core", "axis words without a command that uses them"),
    QT_TRANSLATE_NOOP("core", "the arc does not fit its end point"),
    QT_TRANSLATE_NOOP("core", "the radius is smaller than half the distance of the ends"),
    QT_TRANSLATE_NOOP("core", "centre offsets of the plane are missing"),
    QT_TRANSLATE_NOOP("core", "a word is not used by any command of the line"),
    QT_TRANSLATE_NOOP("core", "G43.1 takes Z only"),
    QT_TRANSLATE_NOOP("core", "the tool number is too large"),
    QT_TRANSLATE_NOOP("core", "the line is not accepted"),
    QT_TRANSLATE_NOOP("core", "radius %1 mm at its start, %2 mm at its end"),
    QT_TRANSLATE_NOOP("core", "F of G93"),
    QT_TRANSLATE_NOOP("core", "P of G4"),
    QT_TRANSLATE_NOOP("core", "P of G10"),
    QT_TRANSLATE_NOOP("core", "L or P of G10"),
    // Klipper.
    QT_TRANSLATE_NOOP("core", "Klipper rejects the line (%1); it is not run"),
    QT_TRANSLATE_NOOP("core", "G20: inches are not supported"),
    QT_TRANSLATE_NOOP("core", "unknown command %1"),
    QT_TRANSLATE_NOOP("core", "invalid speed F"),
    QT_TRANSLATE_NOOP("core", "%1 has no number"),
    QT_TRANSLATE_NOOP("core", "arcs need absolute coordinates"),
    QT_TRANSLATE_NOOP("core", "arcs by radius are not supported"),
    QT_TRANSLATE_NOOP("core", "invalid time P"),
    QT_TRANSLATE_NOOP("core", "invalid factor S"),
    QT_TRANSLATE_NOOP("core", "invalid value of %1"),
    QT_TRANSLATE_NOOP("core", "M204 needs S, or P and T"),
};

}  // namespace

std::span<const char* const> control_sentences() {
  return control_patterns;
}

}  // namespace feedscope::ui
