#include "core/program/heidenhain/heidenhain_core.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/units.h"
#include "core/program/text/read_fault.h"

namespace feedscope {

HeidenhainCore::HeidenhainCore(std::shared_ptr<const SourceText> source, const ReadOptions& options,
                               Progress* progress)
    : Reader(std::move(source), options, progress),
      contour_(path(), log()),
      formulas_(parameters_, [this](const QName& name) { return unset_parameter(name); }),
      unit_(first_unit() == LengthUnit::inch ? units::from_inch(1) : 1) {}

namespace {

/// No more than a block's number.
bool is_number_only(std::string_view statement) {
  return statement.find_first_not_of("0123456789Nn/ \t") == std::string_view::npos;
}

}  // namespace

void HeidenhainCore::run_line(std::string_view line) {
  const std::size_t comment = line.find(';');
  std::string_view statement = line.substr(0, comment);
  const std::size_t last = statement.find_last_not_of(" \t");
  bool goes_on = last != std::string_view::npos && statement[last] == '~';
  if (goes_on) {
    statement = statement.substr(0, last);
  } else if (comment != std::string_view::npos) {
    goes_on = line[line.find_last_not_of(" \t")] == '~';
  }
  if (!goes_on && parts_.empty() && !comment_goes_on_) {
    if (last != std::string_view::npos) {
      run_statement(statement);
    }
    return;
  }
  // "3 ;a long remark that goes on~": all of its lines are remark.
  const bool remark =
      comment_goes_on_ || (parts_.empty() && comment != std::string_view::npos && is_number_only(statement));
  comment_goes_on_ = remark && goes_on;
  if (remark) {
    return;
  }
  parts_.push_back({joined_.size(), this->line()});
  joined_.append(statement) += ' ';
  if (!goes_on) {
    run_joined();
  }
}

void HeidenhainCore::run_joined() {
  try {
    if (joined_.find_first_not_of(" \t") != std::string::npos) {
      run_statement(joined_);
    }
  } catch (const ReadFault& fault) {
    report(Severity::error, fault.code, 0, fault.column, [&] { return Text{fault.message, fault.hint}; });
  }
  joined_.clear();
  parts_.clear();
}

void HeidenhainCore::before_finish() {
  comment_goes_on_ = false;
  run_joined();
  contour_.flush();
}

void HeidenhainCore::run_out() {
  comment_goes_on_ = false;
  run_joined();
  end_of_program();
}

DiagnosticLog::Place HeidenhainCore::spot(std::uint32_t column) const {
  DiagnosticLog::Place spot = place(column);
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
    if (column > part->start || part + 1 == parts_.rend()) {
      const auto length = static_cast<std::uint32_t>(text().line(part->line).size());
      spot.line = part->line;
      spot.column = std::min(column - std::min(column, static_cast<std::uint32_t>(part->start)), length);
      break;
    }
  }
  spot.column = std::min(spot.column, static_cast<std::uint32_t>(text().line(spot.line).size()));
  return spot;
}

BlockPlace HeidenhainCore::contour_place(std::uint32_t column, std::uint8_t axes) const {
  return {shown_line(), parts_.empty() ? place(column) : spot(column), axes, 0};
}

double HeidenhainCore::to_feed(double value) const {
  // In inch programs the control counts feeds in tenths of an inch a minute (TNC 640 Klartext programming,
  // F).
  return units::from_mm_min(is_inch() ? units::from_inch(value / 10) : value);
}

void HeidenhainCore::set_inch(bool inch) {
  unit_ = inch ? units::from_inch(1) : 1;
  say_unit(inch ? LengthUnit::inch : LengthUnit::mm);
}

double HeidenhainCore::unset_parameter(const QName& name) {
  constexpr int tool_radius = 108;
  constexpr int tool_axis = 109;
  constexpr int unit = 113;
  constexpr int first_rotary_axis = 120;
  constexpr int last_rotary_axis = 122;
  if (name.kind == QName::Kind::global) {
    switch (name.number) {
      case tool_radius:
        if (tool_radius_) {
          return *tool_radius_ / unit_;
        }
        break;
      case tool_axis:
        return normal_axis(contour_.plane());
      case unit:
        return is_inch() ? 1 : 0;
      default:
        break;
    }
  }
  if (name.kind == QName::Kind::global && name.number >= first_rotary_axis &&
      name.number <= last_rotary_axis) {
    report(Severity::info, "unset-parameter", name.number, name.column, [&] {
      return Text{fmt::format("{} is the angle of a rotary axis that the control finds for a tilted plane",
                              name.text()),
                  "0 is taken; X, Y and Z are shown in the tilted plane all the same"};
    });
    return 0;
  }
  if (name.kind == QName::Kind::global && name.number == tool_radius) {
    report(Severity::warning, "unset-parameter", name.number, name.column, [] {
      return Text{"Q108 is the tool's radius, which is not known",
                  "0 is taken; write a TOOL DEF with R before the tool call"};
    });
    return 0;
  }
  report(Severity::warning, "unset-parameter", static_cast<int>(name.kind) * 10000 + name.number, name.column,
         [&] {
           return Text{fmt::format("{} has no value yet", name.text()),
                       "0 is taken; a control may still hold another value, assign it before"};
         });
  return 0;
}

}  // namespace feedscope
