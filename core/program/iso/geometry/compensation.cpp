#include "core/program/iso/geometry/compensation.h"

#include <fmt/format.h>

#include "core/program/text/message.h"

namespace feedscope::iso {

namespace {

constexpr int off = 400;
constexpr int first_right = 420;

/// G41.1, G42.1: D is the diameter itself.
bool gives_diameter(int code) {
  return code % 10 == 1;
}

}  // namespace

void Compensation::select_offset() {
  if (words_.has('D') && !is_linuxcnc() && !words_.own_words) {
    offset_ = static_cast<int>(words_['D'].value);
  }
}

void Compensation::run(int code, std::uint32_t column) {
  code_ = code;
  const std::optional<double> radius = code == off ? std::nullopt : this->radius(code, column);
  if (!radius) {
    path().end_compensation();
    return;
  }
  radius_ = *radius;
  begin(column);
}

std::optional<double> Compensation::radius(int code, std::uint32_t column) {
  if (words_.has('D')) {
    const Word& word = words_['D'];
    if (gives_diameter(code)) {
      return modal_.to_mm(word.value) / 2;
    }
    offset_ = static_cast<int>(word.value);
  }
  const bool by_tool = is_linuxcnc() && !words_.has('D');
  const int offset = by_tool ? static_cast<int>(modal_.tool) : offset_;
  if (!gives_diameter(code) && offset == 0 && words_.has('D')) {
    return 0;
  }
  if (!gives_diameter(code) && offset != 0) {
    const auto programmed = radii_.find(offset);
    const std::optional<double> radius = machining_.tools.use_radius_of(
        fmt::format("{}", offset),
        programmed == radii_.end() ? std::nullopt : std::optional(programmed->second));
    if (radius) {
      return radius;
    }
  }
  report(Severity::error, "tool-radius", offset, words_.column_or('D', column), [&] {
    if (gives_diameter(code)) {
      return Text{message(NC_("core", "{} without D"), g_name(code)),
                  NC_("core", "the path shown is the programmed contour; write D with the tool's diameter")};
    }
    if (offset == 0) {
      return Text{
          message(NC_("core", "{} without D: the radius of the tool is not known"), g_name(code)),
          is_linuxcnc()
              ? NC_("core", "the path shown is the programmed contour; write T and M6 before it, or D")
              : NC_("core", "the path shown is the programmed contour; write D with the tool's offset")};
    }
    return Text{
        message(NC_("core", "the radius of offset D{} is not known"), offset),
        message(NC_("core", "the path shown is the programmed contour; {}, or set it with G10 L12 P{} R"),
                ToolRack::radius_hint(fmt::format("{}", offset)), offset)};
  });
  return std::nullopt;
}

void Compensation::follow_block() {
  if (!path().is_compensated()) {
    return;
  }
  if (!words_.has(GGroup::radius) && words_.has('D') && !gives_diameter(code_)) {
    run(code_, words_['D'].column);
  } else if (words_.has(GGroup::plane)) {
    begin(0);
  }
}

void Compensation::begin(std::uint32_t column) {
  const bool right = code_ >= first_right;
  CompensationRule rule;
  if (is_linuxcnc()) {
    rule = linuxcnc_compensation;
  } else if (dialect() == Dialect::fanuc) {
    rule.corner = OutsideCorner::lines;
  }
  path().set_compensation(right ? ToolSide::right : ToolSide::left, radius_, rule, modal_.plane, column);
}

void Compensation::set_radius(int kind, std::uint32_t column) {
  constexpr int radius_wear = 13;
  const bool of_length = (kind == 10 || kind == 11) && dialect() == Dialect::fanuc;
  if (of_length || !words_.has('R')) {
    return;
  }
  if (!lacks("offset-number", 'P', 100, column,
             NC_("core", "the radius is ignored; write P with the tool's number"))) {
    double& entry = radii_[static_cast<int>(words_['P'].value)];
    entry = kind == radius_wear ? entry + length('R') : length('R');
  }
}

}  // namespace feedscope::iso
