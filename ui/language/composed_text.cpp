#include "ui/language/composed_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <array>
#include <optional>
#include <vector>

#include "ui/language/core_texts.h"
#include "ui/language/language.h"

namespace feedscope::ui {

namespace {

/// What core writes with fmt::format(), a place for each of its parts. The first that fits counts. In these
/// the places may hold names and texts of no pattern.
constexpr std::array sentences{
    QT_TRANSLATE_NOOP("core", "motion of %1"),
    // Unit of a program (program/program_unit).
    QT_TRANSLATE_NOOP("core", "%1, by the program"),
    QT_TRANSLATE_NOOP("core", "%1, by --unit"),
    QT_TRANSLATE_NOOP("core", "%1, assumed: the program does not define its unit"),
    // Notes on a run (analysis/run_notes).
    QT_TRANSLATE_NOOP("core",
                      "The program is written for %1, but %2 has a %3: path and times are those of "
                      "that control. No published machine has a %4 control; use your own machine file."),
    QT_TRANSLATE_NOOP("core",
                      "The program is written for %1, but %2 has a %3: path and times are those of "
                      "that control. Use machine %4, whose control reads it."),
    QT_TRANSLATE_NOOP("core", "The program was read with work offsets other than those of the machine (%1)."),
    QT_TRANSLATE_NOOP("core",
                      "The contour tolerance of %1 mm is %2 % of the estimated chord error of the "
                      "short lines (%3 mm); Heidenhain advises 110 to 200 %."),
    QT_TRANSLATE_NOOP("core",
                      "The drive of axis %1 is poorly damped: it overshoots a step by %2 %; a smaller "
                      "%3 or %4 damps it better."),
    QT_TRANSLATE_NOOP("core", "No drive is given for %1: followed exactly."),
    QT_TRANSLATE_NOOP("core", "1 line of the program is refused by the control and not run (line %1)."),
    QT_TRANSLATE_NOOP("core", "%1 lines of the program are refused by the control and not run (lines %2)."),
    QT_TRANSLATE_NOOP("core", "Rotary axes: line %1: %2."),
    QT_TRANSLATE_NOOP("core", "Rotary axes: line %1: %2. %3 more."),
    QT_TRANSLATE_NOOP("core", "Positions of rotary axes that the machine does not reach: line %1: %2."),
    QT_TRANSLATE_NOOP("core",
                      "Positions of rotary axes that the machine does not reach: line %1: %2. %3 more."),
    // Circles of the program (analysis/circularity).
    QT_TRANSLATE_NOOP("core",
                      "The program has no full circle: no cut runs a whole turn in XY, ZX or YZ by "
                      "arcs about one centre. Circles of short lines are not recognised."),
    QT_TRANSLATE_NOOP("core", "The program has %1 full circles; the first %2 are evaluated."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: 1 helix with full turns."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: %1 helices with full turns."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: 1 full circle outside the planes XY, ZX and YZ."),
    QT_TRANSLATE_NOOP("core", "Not evaluated: %1 full circles outside the planes XY, ZX and YZ."),
};

/// In these the places hold numbers and texts that have patterns, too.
constexpr std::array clauses{
    // What is not in the cycle time (analysis/not_counted).
    QT_TRANSLATE_NOOP("core", "%1 tool change"),
    QT_TRANSLATE_NOOP("core", "%1 tool changes"),
    QT_TRANSLATE_NOOP("core", "%1 spindle start"),
    QT_TRANSLATE_NOOP("core", "%1 spindle starts"),
    QT_TRANSLATE_NOOP("core", "%1 program stop (M0, M1)"),
    QT_TRANSLATE_NOOP("core", "%1 program stops (M0, M1)"),
    QT_TRANSLATE_NOOP("core", "%1 move to or from a machine position"),
    QT_TRANSLATE_NOOP("core", "%1 moves to or from machine positions"),
    // Path control (program/path_control); names of units.
    QT_TRANSLATE_NOOP("core", "exact stops"),
    QT_TRANSLATE_NOOP("core", "exact stops (%1)"),
    QT_TRANSLATE_NOOP("core", "continuous"),
    QT_TRANSLATE_NOOP("core", "contour tolerance %1 mm"),
    QT_TRANSLATE_NOOP("core", "blends from %1 mm before the corner"),
    QT_TRANSLATE_NOOP("core", "orientation tolerance %1 deg"),
    QT_TRANSLATE_NOOP("core", "compaction tolerance %1 mm"),
    QT_TRANSLATE_NOOP("core", "compaction on"),
    QT_TRANSLATE_NOOP("core", "compaction off"),
    QT_TRANSLATE_NOOP("core", "smooth curves on"),
    QT_TRANSLATE_NOOP("core", "smooth curves off"),
    QT_TRANSLATE_NOOP("core", "feed forward on"),
    QT_TRANSLATE_NOOP("core", "feed forward off"),
    QT_TRANSLATE_NOOP("core", "look-ahead on"),
    QT_TRANSLATE_NOOP("core", "look-ahead off"),
    QT_TRANSLATE_NOOP("core", "jerk limited"),
    QT_TRANSLATE_NOOP("core", "acceleration in steps"),
    QT_TRANSLATE_NOOP("core", "acceleration falling with speed"),
    QT_TRANSLATE_NOOP("core", "as the machine"),
    QT_TRANSLATE_NOOP("core", "fine"),
    QT_TRANSLATE_NOOP("core", "coarse"),
    QT_TRANSLATE_NOOP("core", "interpolation end"),
    QT_TRANSLATE_NOOP("core", "inch"),
    // Messages of the reader (base/diagnostic).
    QT_TRANSLATE_NOOP("core", "error"),
    QT_TRANSLATE_NOOP("core", "warning"),
    QT_TRANSLATE_NOOP("core", "info"),
    QT_TRANSLATE_NOOP("core", "also in line %1"),
    QT_TRANSLATE_NOOP("core", "also in lines %1 and %2"),
    QT_TRANSLATE_NOOP("core", "%1 more up to line %2"),
    QT_TRANSLATE_NOOP("core", "%1 more"),
    // What a control model guarantees (models/guarantees).
    QT_TRANSLATE_NOOP("core",
                      "The source covers lines and their corners; arcs and helices follow the shared rules."),
    QT_TRANSLATE_NOOP("core", "The source covers arcs; lines follow the shared rules."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed path is followed by straight blocks, arcs by chords within the "
                      "arc tolerance; no corner is blended. Ends of blocks are rounded to whole steps "
                      "of the axes."),
    QT_TRANSLATE_NOOP(
        "core", "The programmed path is followed by straight blocks, arcs by chords; no corner is blended."),
    QT_TRANSLATE_NOOP("core", "The programmed path is followed exactly; no corner is blended."),
    QT_TRANSLATE_NOOP("core", "The distance of programmed corners from the path is not bounded."),
    QT_TRANSLATE_NOOP("core",
                      "The distance of programmed corners from the path is not bounded; tangent "
                      "transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core", "Every programmed corner lies within the contour tolerance of the path."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within the contour tolerance of the path; tangent "
                      "transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within %1 times the contour tolerance of the path."),
    QT_TRANSLATE_NOOP("core",
                      "Every programmed corner lies within %1 times the contour tolerance of the path; "
                      "tangent transitions between blocks are passed exactly."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed feed is kept along every block; where two blocks overlap their "
                      "speeds add."),
    QT_TRANSLATE_NOOP("core",
                      "The programmed feed is met to whole steps and counts of a timer; very slow "
                      "feeds are exceeded."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1; rapids run at the maximum velocity of the control."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1; rapids never faster than the axes allow."),
    QT_TRANSLATE_NOOP("core", "Never faster than %1 times %2."),
    QT_TRANSLATE_NOOP("core", "the largest programmed feed between two standstills"),
    QT_TRANSLATE_NOOP("core", "the programmed feed"),
    QT_TRANSLATE_NOOP("core", "On lines: %1."),
    QT_TRANSLATE_NOOP("core", "On arcs: %1."),
    QT_TRANSLATE_NOOP("core", "On corner blends: %1."),
    QT_TRANSLATE_NOOP("core", "On smooth curves: %1."),
    QT_TRANSLATE_NOOP("core",
                      "%1 of every axis: along and across the path it stays within %2 each, together "
                      "within %3 times the limit"),
    QT_TRANSLATE_NOOP("core",
                      "%1 of every axis: along the path the change of the acceleration (v'') and the "
                      "part due to curvature (v^3 k^2) each stay within %2, together within %3 times "
                      "the limit"),
    QT_TRANSLATE_NOOP("core", "across the path (3 v v' k) it is not bounded"),
    QT_TRANSLATE_NOOP("core", "the limit"),
    QT_TRANSLATE_NOOP("core", "%1 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis are kept"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis is kept"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis stay within %2 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 of every axis stays within %2 times the limit"),
    QT_TRANSLATE_NOOP("core", "%1 are not bounded"),
    QT_TRANSLATE_NOOP("core", "%1 is not bounded"),
    QT_TRANSLATE_NOOP("core", "velocity"),
    QT_TRANSLATE_NOOP("core", "acceleration"),
    QT_TRANSLATE_NOOP("core", "jerk"),
    QT_TRANSLATE_NOOP("core", "jerk (blend_jerk)"),
    QT_TRANSLATE_NOOP("core", "The speed jumps along the path."),
    QT_TRANSLATE_NOOP(
        "core", "The speed is continuous; the acceleration jumps where the curvature of the path does."),
    QT_TRANSLATE_NOOP("core", "Velocity and acceleration are continuous everywhere."),
    QT_TRANSLATE_NOOP("core",
                      "Where the program asks for BRISK, no jerk along the path is bounded: its "
                      "acceleration changes within one interpolation period."),
    QT_TRANSLATE_NOOP("core", "BRISK of the program is not followed."),
    QT_TRANSLATE_NOOP("core",
                      "A junction that touches an arc and turns by up to 0.01 rad is passed as if it "
                      "were tangent: there the velocity of an axis jumps by up to 1 % of the feed "
                      "(1 mm/s at 6000 mm/min)."),
    QT_TRANSLATE_NOOP("core", "Full stops at dwells only."),
    QT_TRANSLATE_NOOP("core", "Full stops %1."),
    QT_TRANSLATE_NOOP("core", "at corners of lines"),
    QT_TRANSLATE_NOOP("core", "at corners that touch an arc"),
    QT_TRANSLATE_NOOP("core", "at reversals"),
    QT_TRANSLATE_NOOP("core", "before and after every rapid"),
};

/// Lists and ranges: two parts, which hold numbers and texts that have patterns, with this between them.
constexpr std::array joints{QT_TRANSLATE_NOOP("core", "%1; %2"), QT_TRANSLATE_NOOP("core", "%1 and %2"),
                            QT_TRANSLATE_NOOP("core", "%1, %2"), QT_TRANSLATE_NOOP("core", "%1 to %2")};

struct Pattern {
  const char* text;
  bool has_names;
  QRegularExpression expression;
};

/// Words stand for themselves, places for what is there.
QRegularExpression expression_of(const char* text) {
  static const QRegularExpression place(QStringLiteral("%\\d"));
  const QString pattern = QString::fromUtf8(text);
  QString expression;
  qsizetype at = 0;
  for (QRegularExpressionMatchIterator places = place.globalMatch(pattern); places.hasNext();) {
    const QRegularExpressionMatch found = places.next();
    expression +=
        QRegularExpression::escape(pattern.mid(at, found.capturedStart() - at)) + QStringLiteral("(.+?)");
    at = found.capturedEnd();
  }
  expression += QRegularExpression::escape(pattern.mid(at));
  return QRegularExpression(QRegularExpression::anchoredPattern(expression));
}

const std::vector<Pattern>& all_patterns() {
  static const std::vector<Pattern> all = [] {
    std::vector<Pattern> made;
    for (const char* text : sentences) {
      made.push_back({text, true, expression_of(text)});
    }
    for (const char* text : clauses) {
      made.push_back({text, false, expression_of(text)});
    }
    return made;
  }();
  return all;
}

std::optional<QString> known_text(const QString& text);

std::optional<QString> number(const QString& text) {
  static const QRegularExpression digits(QStringLiteral("^-?\\d+(\\.\\d+)?$"));
  return digits.match(text).hasMatch() ? std::optional(QString(text).replace('.', QLocale().decimalPoint()))
                                       : std::nullopt;
}

std::optional<QString> by_pattern(const Pattern& pattern, const QString& text) {
  const QRegularExpressionMatch found = pattern.expression.match(text);
  if (!found.hasMatch()) {
    return std::nullopt;
  }
  QString made = QCoreApplication::translate("core", pattern.text);
  for (int i = found.lastCapturedIndex(); i >= 1; --i) {
    const std::optional<QString> part = known_text(found.captured(i));
    if (!part && !pattern.has_names) {
      return std::nullopt;
    }
    made.replace(QStringLiteral("%%1").arg(i), part.value_or(found.captured(i)));
  }
  return made;
}

std::optional<QString> by_joint(const char* joint, const QString& text) {
  const QString between =
      QString::fromUtf8(joint).section(QStringLiteral("%1"), 1).section(QStringLiteral("%2"), 0, 0);
  for (qsizetype at = text.indexOf(between); at >= 0; at = text.indexOf(between, at + 1)) {
    const std::optional<QString> first = known_text(text.left(at));
    const std::optional<QString> second = first ? known_text(text.mid(at + between.size())) : std::nullopt;
    if (second) {
      return QCoreApplication::translate("core", joint).arg(*first, *second);
    }
  }
  return std::nullopt;
}

/// None: no pattern has it.
std::optional<QString> known_text(const QString& text) {
  if (const auto digits = number(text)) {
    return digits;
  }
  if (const QString whole = core_text(text.toStdString()); whole != text) {
    return whole;
  }
  for (const Pattern& pattern : all_patterns()) {
    if (const auto made = by_pattern(pattern, text)) {
      return made;
    }
  }
  for (const char* joint : joints) {
    if (const auto made = by_joint(joint, text)) {
      return made;
    }
  }
  return std::nullopt;
}

}  // namespace

QString composed_text(const std::string& text) {
  return composed_text(QString::fromStdString(text));
}

QString composed_text(const QString& text) {
  return speaks_english() ? text : known_text(text).value_or(text);
}

}  // namespace feedscope::ui
