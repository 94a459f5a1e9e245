#include "ui/why/why_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/analysis/run/quantity.h"
#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/significant.h"

namespace feedscope::ui {

namespace {

/// Removes rounding errors around zero, in display units: 1 nm, 1 ns, 1 nm/s and the like.
double without_noise(double value, Dimension dimension) {
  constexpr double least = 1e-6;  // mm, mm/s, mm/s2, mm/s3; rad
  constexpr double instant = 1e-9;
  switch (dimension) {
    case Dimension::length:
    case Dimension::feed:
    case Dimension::acceleration:
    case Dimension::jerk:
    case Dimension::angle:
      return std::abs(value) < least ? 0 : value;
    case Dimension::time:
      return std::abs(value) < instant ? 0 : value;
    default:
      return value;
  }
}

QString axis_text(Cause cause) {
  return cause.axis < 0 ? QString() : QString(QLatin1Char(axis_name(cause)));
}

QString turn_kind_sentence(Cause cause) {
  const QString text =
      cause.kind == CauseKind::axis_velocity
          ? WhyText::tr("Rotary axis %1 turns along this block as fast as its velocity limit allows.")
      : cause.kind == CauseKind::axis_acceleration
          ? WhyText::tr(
                "Rotary axis %1 turns along this block or beside it: its acceleration limit holds the "
                "change of speed.")
          : WhyText::tr(
                "Rotary axis %1 turns along this block or beside it: its jerk limit holds the change of "
                "speed.");
  return text.arg(axis_text(cause));
}

/// The axis of the numbers in the formula.
QString axis_of_formula(const Reason& reason) {
  const auto of_axis = [](const Quantity& quantity) { return quantity.axis >= 0; };
  const auto found = std::ranges::find_if(reason.formula.numbers, of_axis);
  return found == reason.formula.numbers.end()
             ? QStringLiteral("–")
             : QString(QLatin1Char(cause_axes[static_cast<std::size_t>(found->axis)].name));
}

QString of_symbol(const Reason& reason, Symbol symbol) {
  const Quantity* found = reason.formula.find(symbol);
  return found == nullptr ? QStringLiteral("–") : WhyText::number(found->value, dimension_of(symbol));
}

QString share_of(double share) {
  constexpr double least = 0.01;
  return share < least ? WhyText::tr("less than 1 %")
                       : QStringLiteral("%1 %").arg(significant_number(100 * share, 3));
}

QString percent(const Reason& reason, Symbol symbol) {
  const Quantity* found = reason.formula.find(symbol);
  return found == nullptr ? QStringLiteral("–") : share_of(found->value);
}

/// The share of an axis limit that turning leaves for changes of speed; "" for another formula.
QString turn_ramp_sentence(const Reason& reason) {
  const bool rotary = reason.cause.axis >= static_cast<std::int8_t>(known_axes.size());
  const auto filled = [&](const QString& text, Symbol of_rotary, Symbol of_linear) {
    return text.arg(axis_text(reason.cause), percent(reason, Symbol::turning_share),
                    of_symbol(reason, rotary ? of_rotary : of_linear));
  };
  switch (reason.formula.id) {
    case FormulaId::turning_ramp_acceleration:
      return filled(
          rotary ? WhyText::tr("Rotary axis %1 turns along this block or beside it; turning takes %2 of its "
                               "maximum acceleration, %3, and changes of the speed have the rest.")
                 : WhyText::tr("Rotary axes turn along this block or beside it; that takes %2 of the maximum "
                               "acceleration of axis %1, %3, and changes of the speed have the rest."),
          Symbol::rotary_acceleration, Symbol::axis_acceleration);
    case FormulaId::turning_ramp_jerk:
      return filled(
          rotary ? WhyText::tr("Rotary axis %1 turns along this block or beside it; turning takes %2 of its "
                               "maximum jerk, %3, and changes of the acceleration have the rest.")
                 : WhyText::tr("Rotary axes turn along this block or beside it; that takes %2 of the maximum "
                               "jerk of axis %1, %3, and changes of the acceleration have the rest."),
          Symbol::rotary_jerk, Symbol::axis_jerk);
    case FormulaId::turning_ramp_bend:
      return filled(
          rotary
              ? WhyText::tr("Rotary axis %1 does not turn evenly along this block or beside it, so that "
                            "every change of the speed takes jerk: %2 of its maximum, %3, is for that.")
              : WhyText::tr("Rotary axes turn along this block or beside it and axis %1 makes up for that, "
                            "so that every change of the speed takes jerk: %2 of its maximum, %3, is for "
                            "that."),
          Symbol::rotary_jerk, Symbol::axis_jerk);
    default:
      return {};
  }
}

/// With limit and speed of the axis if the formula contains them, and the distance of the singular place.
QString turn_sentence(const Reason& reason) {
  QString text = turn_kind_sentence(reason.cause);
  const bool velocity = reason.formula.id == FormulaId::turning_velocity;
  if (velocity && reason.formula.find(Symbol::rotary_velocity) != nullptr) {
    text = WhyText::tr(
               "Rotary axis %1 turns along this block at its maximum velocity, %2: it turns by %3 of "
               "path.")
               .arg(axis_text(reason.cause), of_symbol(reason, Symbol::rotary_velocity),
                    of_symbol(reason, Symbol::turn_slope));
  } else if (velocity) {
    text = WhyText::tr(
               "Rotary axes turn along this block; axis %1, which makes up for that, runs at its "
               "maximum velocity, %2: it moves %3 times as far as the tip.")
               .arg(axis_text(reason.cause), of_symbol(reason, Symbol::axis_velocity),
                    of_symbol(reason, Symbol::axis_slope));
  }
  if (const QString ramp = turn_ramp_sentence(reason); !ramp.isEmpty()) {
    text = ramp;
  }
  constexpr double near = 10 * units::pi / 180;
  if (reason.tilt && *reason.tilt <= near) {
    text += ' ' + WhyText::tr(
                      "The tool is %1 from the first rotary axis, near the singular position, where "
                      "that axis turns by 1/sin of this angle.")
                      .arg(WhyText::number(*reason.tilt, Dimension::angle));
  }
  return text;
}

/// Powers as superscripts, indices as subscripts, Greek letters as signs.
QString as_rich_text(const QString& plain) {
  QString text = plain.toHtmlEscaped();
  static const QRegularExpression power(QStringLiteral("\\^(?:\\((\\d+/\\d+)\\)|(\\d+))"));
  static const QRegularExpression index(QStringLiteral("_([A-Za-z0-9]+)"));
  text.replace(power, QStringLiteral("<sup>\\1\\2</sup>"));
  text.replace(index, QStringLiteral("<sub>\\1</sub>"));
  text.replace(QStringLiteral("phi"), QStringLiteral("φ"));
  text.replace(QStringLiteral("eps"), QStringLiteral("ε"));
  text.replace(QStringLiteral("dk"), QStringLiteral("Δk"));
  return text;
}

}  // namespace

QString WhyText::number(double asked, Dimension dimension) {
  const double value = without_noise(asked, dimension);
  switch (dimension) {
    case Dimension::number:
      return significant_number(value, 3);
    case Dimension::time:
      return value < 0.1 ? tr("%1 ms").arg(significant_number(1000 * value, 4))
                         : tr("%1 s").arg(significant_number(value, 4));
    case Dimension::feed:
      return speed(value);
    case Dimension::angle:
      return tr("%1°").arg(significant_number(units::to_deg(value), 4));
    default:
      return QStringLiteral("%1 %2").arg(significant_number(in_shown_unit(value, dimension), 4),
                                         unit_of(dimension));
  }
}

QString WhyText::speed(double value) {
  const double feed = in_shown_unit(without_noise(value, Dimension::feed), Dimension::feed);
  return QStringLiteral("%1 %2").arg(
      feed >= 100 ? QLocale().toString(feed, 'f', 0) : significant_number(feed, 3), unit_of(Dimension::feed));
}

QString WhyText::cause(Cause cause) {
  QString title = shown_cause(cause);
  return title.replace(0, 1, title.left(1).toUpper());
}

QString WhyText::blend_sentence(const Reason& reason) {
  const QString axis = axis_text(reason.cause);
  switch (reason.cause.kind) {
    case CauseKind::blend_velocity:
      return tr("On the corner blend, axis %1 runs at its maximum velocity, %2.")
          .arg(axis, of_symbol(reason, Symbol::axis_velocity));
    case CauseKind::blend_radial_acceleration:
      return tr("On the corner blend (radius %1), radial acceleration may use %2 of the acceleration limit "
                "of axis %3, %4.")
          .arg(of_symbol(reason, Symbol::radius), percent(reason, Symbol::acceleration_share), axis,
               of_symbol(reason, Symbol::axis_acceleration));
    case CauseKind::blend_radial_jerk:
      return tr("On the corner blend, radial jerk may use %1 of the jerk limit of axis %2, %3, and the "
                "curvature changes quickly.")
          .arg(percent(reason, Symbol::jerk_share), axis, of_symbol(reason, Symbol::blend_jerk));
    case CauseKind::blend_tangential_acceleration:
      return tr("The corner blend reserves a share of the acceleration limit of axis %1, %2, for radial "
                "acceleration: %3; the rest limits the change of speed.")
          .arg(axis, of_symbol(reason, Symbol::axis_acceleration),
               percent(reason, Symbol::acceleration_share));
    default:
      return tr("The corner blend reserves a share of the jerk limit of axis %1, %2, for radial jerk: %3; "
                "the rest limits how fast the acceleration changes.")
          .arg(axis, of_symbol(reason, Symbol::blend_jerk), percent(reason, Symbol::jerk_share));
  }
}

QString WhyText::arc_sentence(const Reason& reason) {
  const QString axis = axis_text(reason.cause);
  const QString radius = of_symbol(reason, Symbol::radius);
  return reason.cause.kind == CauseKind::radial_jerk
             ? tr("On the radius of %1, radial jerk uses the full jerk of axis %2, %3.")
                   .arg(radius, axis, of_symbol(reason, Symbol::axis_jerk))
             : tr("On the radius of %1, radial acceleration uses the full acceleration of axis %2, %3.")
                   .arg(radius, axis, of_symbol(reason, Symbol::axis_acceleration));
}

QString WhyText::curve_sentence(const Reason& reason) {
  const QString axis = axis_text(reason.cause);
  return reason.cause.kind == CauseKind::radial_jerk
             ? tr("The smooth curve through the blocks bends here, and its bend changes: turning takes %1 of "
                  "the jerk of axis %2, %3; the rest is for changes of speed.")
                   .arg(percent(reason, Symbol::turning_share), axis, of_symbol(reason, Symbol::axis_jerk))
             : tr("The smooth curve through the blocks bends here: turning takes %1 of the acceleration of "
                  "axis %2, %3; the rest is for changes of speed.")
                   .arg(percent(reason, Symbol::turning_share), axis,
                        of_symbol(reason, Symbol::axis_acceleration));
}

QString WhyText::ramp_sentence(const Reason& reason, const State& state) {
  const QString axis = axis_text(reason.cause);
  if (reason.formula.id == FormulaId::filter_delay) {
    return tr("The filters of the control spread every change of feed over %1.")
        .arg(number(reason.formula.value(), Dimension::time));
  }
  const bool by_jerk = reason.cause.kind == CauseKind::axis_jerk;
  const bool whole =
      reason.formula.id == FormulaId::whole_acceleration || reason.formula.id == FormulaId::whole_jerk;
  if (whole) {
    const QString limit = number(reason.reached, by_jerk ? Dimension::jerk : Dimension::acceleration);
    return by_jerk ? tr("Axis %1 is at its maximum jerk, %2, along and across the path combined.")
                         .arg(axis, limit)
                   : tr("Axis %1 is at its maximum acceleration, %2, along and across the path combined.")
                         .arg(axis, limit);
  }
  if (!by_jerk && reason.formula.empty()) {
    return tr("The tool accelerates with %1, what turning and blends leave of the acceleration of the axes.")
        .arg(number(reason.reached, Dimension::acceleration));
  }
  const QString limit = number(reason.formula.value(), by_jerk ? Dimension::jerk : Dimension::acceleration);
  if (state.tangential_jerk == 0 && state.tangential_acceleration == 0) {
    return tr("The tool keeps its speed between two speed changes; with a jerk of %1 along the path they "
              "take too long to gain more.")
        .arg(limit);
  }
  return by_jerk ? tr("The tool accelerates; the jerk of axis %1 allows %2 along the path.").arg(axis, limit)
                 : tr("The tool accelerates; axis %1 allows %2 along the path.").arg(axis, limit);
}

QString WhyText::tolerance_sentence(const Reason& reason) {
  const QString tolerance = number(reason.reached, Dimension::length);
  const bool used_up = reason.formula.empty() || reason.sets_it();
  return used_up ? tr("At a higher feed the filters would deviate from the programmed contour by more than "
                      "the tolerance of %1.")
                       .arg(tolerance)
                 : tr("These places are closer together than the filters of the control reach: this one "
                      "alone uses %1 of the contour tolerance, %2; together they need more.")
                       .arg(number(reason.formula.value(), Dimension::length), tolerance);
}

/// For a model whose junctions take a part of the acceleration: the formula is of an executed arc, or there
/// is none.
bool WhyText::is_of_joints(const Reason& reason) {
  return reason.formula.id == FormulaId::shared_radial_acceleration ||
         (reason.formula.empty() && reason.reached == 0);
}

QString WhyText::joint_sentence(const Reason& reason) {
  const bool in_corner = reason.cause.kind == CauseKind::contour_tolerance;
  if (reason.formula.empty()) {
    return in_corner ? tr("In the corner the control goes over from one block to the next within the blend "
                          "tolerance, with what that leaves of the acceleration.")
                     : tr("Turning on the arc takes the part of the acceleration that the control keeps "
                          "for it.");
  }
  const QString radius = of_symbol(reason, Symbol::radius);
  const QString share = percent(reason, Symbol::acceleration_share);
  const QString axis = axis_of_formula(reason);
  return in_corner ? tr("The control rounds the corner with an arc of radius %1 within the blend tolerance; "
                        "turning on it takes %2 of the acceleration of axis %3.")
                         .arg(radius, share, axis)
                   : tr("On the radius of %1 turning takes %2 of the acceleration of axis %3; the control "
                        "keeps the rest for changes of speed.")
                         .arg(radius, share, axis);
}

QString WhyText::limit_sentence(const Reason& reason, const State& state) {
  const QString axis = axis_text(reason.cause);
  const bool rotary = reason.cause.axis >= static_cast<std::int8_t>(known_axes.size());
  const bool of_turn = reason.formula.id >= FormulaId::turning_velocity;
  if ((rotary || of_turn) && !is_pause(reason.cause.kind)) {
    return turn_sentence(reason);
  }
  const QString radius = of_symbol(reason, Symbol::radius);
  switch (reason.cause.kind) {
    case CauseKind::programmed_feed:
      return reason.formula.empty() || reason.sets_it()
                 ? tr("The tool runs at the programmed feed: F %1.").arg(of_symbol(reason, Symbol::feed))
                 : tr("The tool accelerates and levels off in time for the programmed F %1.")
                       .arg(of_symbol(reason, Symbol::feed));
    case CauseKind::rapid:
      return tr("Rapid traverse: axis %1 runs at its maximum velocity, %2.")
          .arg(axis, of_symbol(reason, Symbol::axis_velocity));
    case CauseKind::axis_velocity:
      return tr("Axis %1 runs at its maximum velocity, %2.")
          .arg(axis, of_symbol(reason, Symbol::axis_velocity));
    case CauseKind::axis_acceleration:
    case CauseKind::axis_jerk:
    case CauseKind::velocity_filter:
      return ramp_sentence(reason, state);
    case CauseKind::radial_acceleration:
    case CauseKind::radial_jerk:
      if (reason.formula.find(Symbol::turning_share) != nullptr) {
        return curve_sentence(reason);
      }
      return is_of_joints(reason) ? joint_sentence(reason) : arc_sentence(reason);
    case CauseKind::curvilinear_jerk:
      return tr("On the radius of %1 the control allows a curvilinear jerk of %2, of which %3 along the "
                "path.")
          .arg(radius, of_symbol(reason, Symbol::curvilinear_jerk),
               percent(reason, Symbol::tangential_share));
    case CauseKind::curvature_crossing:
      return tr("The curvature jumps: axis %1 must absorb the change with its jerk of %2 within one "
                "interpolation period, %3.")
          .arg(axis, of_symbol(reason, Symbol::axis_jerk), of_symbol(reason, Symbol::period));
    case CauseKind::interpolation_period:
      return tr("The block is %1 long and takes the control at least one interpolation period, %2.")
          .arg(of_symbol(reason, Symbol::block_length), of_symbol(reason, Symbol::period));
    case CauseKind::block_time:
      return tr("The block is %1 long and takes the control at least %2 to prepare: longer blocks, with "
                "fewer "
                "points, are faster.")
          .arg(of_symbol(reason, Symbol::block_length), of_symbol(reason, Symbol::block_time));
    case CauseKind::contour_tolerance:
      return is_of_joints(reason) ? joint_sentence(reason) : tolerance_sentence(reason);
    case CauseKind::lookahead_horizon:
      return tr("The control looks ahead over the next %1 of the path and must be able to stop within them.")
          .arg(of_symbol(reason, Symbol::length_ahead));
    case CauseKind::junction_deviation:
      return tr("In the corner the control allows the speed at which an arc no farther from it than %1 would "
                "use the full acceleration of axis %2, %3.")
          .arg(of_symbol(reason, Symbol::junction_deviation), axis_of_formula(reason),
               of_symbol(reason, Symbol::axis_acceleration));
    case CauseKind::square_corner_velocity:
      return tr("The control allows %1 in a corner of 90°, and here as much more or less as the corner is "
                "wider or sharper.")
          .arg(of_symbol(reason, Symbol::corner_velocity));
    case CauseKind::cruise_ratio:
      return tr(
          "The control keeps a part of the way between two slow places for constant speed, so that the "
          "tool does not accelerate any further.");
    case CauseKind::kink:
      return tr("Where the blocks meet the velocity jumps: the axes must absorb that within one period.");
    case CauseKind::path_velocity:
      return tr("The tool runs at the largest speed that the control allows along the path.");
    case CauseKind::path_acceleration:
      return tr("The tool accelerates as much as the control allows along the path.");
    case CauseKind::exact_stop:
      return stop_sentence(reason.stop);
    case CauseKind::dwell:
      return tr("The program waits.");
    case CauseKind::tool_change:
      return tr("Tool change: it takes the tool change time of the machine.");
    case CauseKind::spindle_start:
      return tr(
          "The axes wait until the spindle has reached its speed; the time is the machine's spindle "
          "start time.");
    case CauseKind::indexing:
      return tr("Rotary axis %1 turns while the tool stands: it takes what the limits of this axis allow, or "
                "the programmed feed if that is lower.")
          .arg(QLatin1Char(axis_name(reason.cause)));
    case CauseKind::swing:
      return tr("The tool turns about its tip, which X, Y and Z hold: it takes what the limits of axis %1 "
                "allow, or the programmed feed in degrees a minute if that is lower.")
          .arg(QLatin1Char(axis_name(reason.cause)));
    default:
      return blend_sentence(reason);
  }
}

QString WhyText::stop_sentence(StopReason reason) {
  switch (reason) {
    case StopReason::end:
      return tr("The tool must stop: the program begins or ends here.");
    case StopReason::rapid:
      return tr("The tool must stop: a rapid begins or ends here.");
    case StopReason::tolerance:
      return tr("The tool must stop: an exact stop or a contour tolerance of 0 is in force.");
    case StopReason::unknown:
      break;
  }
  return tr("The tool must stop.");
}

QString WhyText::sentence(const Explanation& why) {
  if (why.state.cause.kind != CauseKind::ramp_down || !why.ahead) {
    return limit_sentence(why.reason, why.state);
  }
  const QString distance = number(why.ahead->path_length - why.state.path_length, Dimension::length);
  const QString time = number(why.ahead->time - why.state.time, Dimension::time);
  if (!(why.ahead->speed > 1e-9)) {
    return tr("The tool brakes: in %1 (%2) it must stop, line %3.")
        .arg(distance, time, QString::number(why.ahead->reason.line));
  }
  return tr("The tool brakes: in %1 (%2), in line %3, only %4 is possible.")
      .arg(distance, time, QString::number(why.ahead->reason.line), speed(why.ahead->speed));
}

QString WhyText::sentence(const SlowerPlace& ahead, const State& now) {
  State there = now;
  there.tangential_acceleration = there.tangential_jerk = 1;
  const bool stands = ahead.reason.cause.kind == CauseKind::exact_stop || is_pause(ahead.reason.cause.kind);
  if (ahead.reason.formula.empty() && !stands) {
    return tr("It is slowed by a place further ahead.");
  }
  return limit_sentence(ahead.reason, there);
}

QString WhyText::sentence(Cause cause, const Explanation& why) {
  const bool ahead = why.ahead && why.ahead->reason.cause == cause;
  return ahead ? sentence(*why.ahead, why.state) : sentence(why);
}

QString WhyText::drives(const ActualPath* actual, const State& state) {
  if (actual == nullptr) {
    return {};
  }
  constexpr double worth_telling = 1e-3;  // [mm]
  const ActualSample sample = actual->at(state);
  const double of_control = actual->set_contour_error(state);
  if (sample.contour_error < worth_telling || sample.contour_error < 2 * of_control) {
    return {};
  }
  const double across = info_of(QuantityId::following_error_across).of(Instant(state, &sample));
  return tr("Contour error %1, of which the set path has %2: the drives make most of it. The axes are %3 "
            "behind "
            "across the path; a higher Kv, more feed-forward or a lower feed reduces that.")
      .arg(number(sample.contour_error, Dimension::error), number(of_control, Dimension::error),
           number(across, Dimension::error));
}

QString WhyText::formula(const Reason& reason) {
  if (reason.formula.empty()) {
    return {};
  }
  const auto write = [](const Quantity& quantity) {
    return number(quantity.value, dimension_of(quantity.symbol)).toStdString();
  };
  const QString numbers = QString::fromStdString(reason.formula.with_numbers(write));
  const QString result = number(reason.formula.value(), reason.formula.dimension());
  const QString symbols =
      as_rich_text(QString::fromStdString(reason.formula.left() + " = " + reason.formula.text()));
  return numbers == result
             ? QStringLiteral("%1 = <b>%2</b>").arg(symbols, result)
             : QStringLiteral("%1<br/>= %2<br/>= <b>%3</b>").arg(symbols, as_rich_text(numbers), result);
}

QString WhyText::source(const Reason& reason) {
  if (reason.source == "program") {
    return tr("from the program");
  }
  return QString::fromStdString(reason.source);
}

}  // namespace feedscope::ui
