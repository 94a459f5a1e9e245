// The part of IsoReader that switches cutter radius compensation: G40 to G42.1.
#include <fmt/format.h>

#include "core/program/iso/iso_reader.h"
#include "core/program/text/message.h"

namespace feedscope {

namespace {

constexpr int off = 400;
constexpr int first_right = 420;

/// G41.1, G42.1: D is the diameter itself.
bool gives_diameter(int code) {
  return code % 10 == 1;
}

}  // namespace

void IsoReader::compensate(int code, std::uint32_t column) {
  state_.compensation.code = code;
  const std::optional<double> radius = code == off ? std::nullopt : compensation_radius(code, column);
  if (!radius) {
    path().end_compensation();
    return;
  }
  state_.compensation.radius = *radius;
  begin_compensation(column);
}

std::optional<double> IsoReader::compensation_radius(int code, std::uint32_t column) {
  if (words_.has('D')) {
    const Word& word = words_['D'];
    if (gives_diameter(code)) {
      return state_.to_mm(word.value) / 2;
    }
    state_.compensation.offset = static_cast<int>(word.value);
  }
  const bool by_tool = follows_linuxcnc(dialect_) && !words_.has('D');
  const int offset = by_tool ? static_cast<int>(state_.tool) : state_.compensation.offset;
  if (!gives_diameter(code) && offset == 0 && words_.has('D')) {
    return 0;
  }
  if (!gives_diameter(code) && offset != 0) {
    const auto programmed = tool_radii_.find(offset);
    const std::optional<double> radius =
        use_cutter(fmt::format("{}", offset),
                   programmed == tool_radii_.end() ? std::nullopt : std::optional(programmed->second));
    if (radius) {
      return radius;
    }
  }
  report(Severity::error, "tool-radius", offset, words_.has('D') ? words_['D'].column : column, [&] {
    if (gives_diameter(code)) {
      return Text{fmt::format("{} without D", g_name(code)),
                  "the path shown is the programmed contour; write D with the tool's diameter"};
    }
    if (offset == 0) {
      return Text{
          fmt::format("{} without D: the radius of the tool is not known", g_name(code)),
          fmt::format("the path shown is the programmed contour; write {}",
                      follows_linuxcnc(dialect_) ? "T and M6 before it, or D" : "D with the tool's offset")};
    }
    return Text{fmt::format("the radius of offset D{} is not known", offset),
                fmt::format("the path shown is the programmed contour; {}, or set it with G10 L12 P{} R",
                            radius_hint(fmt::format("{}", offset)), offset)};
  });
  return std::nullopt;
}

void IsoReader::renew_compensation() {
  const int code = state_.compensation.code;
  if (words_.groups[static_cast<std::size_t>(GGroup::radius)] == nullptr && words_.has('D') &&
      !gives_diameter(code)) {
    compensate(code, words_['D'].column);
  } else if (words_.groups[static_cast<std::size_t>(GGroup::plane)] != nullptr) {
    begin_compensation(0);
  }
}

void IsoReader::begin_compensation(std::uint32_t column) {
  const bool right = state_.compensation.code >= first_right;
  const bool on_lines = dialect_ == Dialect::fanuc;
  path().set_compensation(right ? ToolSide::right : ToolSide::left, state_.compensation.radius,
                          on_lines ? OutsideCorner::lines : OutsideCorner::arc, state_.plane, column);
}

}  // namespace feedscope
