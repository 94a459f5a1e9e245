#include "core/program/heidenhain/language/system_data.h"

#include <fmt/format.h>

#include "core/base/units.h"

namespace feedscope::heidenhain {

void SystemData::read(Scanner& scanner, std::uint32_t column) {
  scanner.take_keyword("SYSREAD");
  const std::optional<QName> result = take_parameter(scanner);
  if (!result || result->kind == QName::Kind::text || !scanner.take('=') || !scanner.take("ID")) {
    throw_unread_words(scanner, Message::as_written("FN 18"));
  }
  const double group = read_value(scanner);
  const double number = scanner.take("NR") ? read_value(scanner) : 0;
  const double index = scanner.take("IDX") ? read_value(scanner) : 0;
  assign(*result, group, number, index, column);
}

/// iTNC 530 HSCI technical manual, 9.5.4. System data are metric whatever the unit of the program.
std::optional<double> SystemData::value(double group, double number, double index) const {
  const auto asks = [&](int g, int n) { return group == g && number == n; };
  const int axis = index == 1 || index == 2 || index == 3 ? static_cast<int>(index) - 1 : -1;
  if (asks(10, 1)) {
    return modal_.is_inch() ? 1 : 0;
  }
  if (asks(20, 1)) {
    return tools_.number();
  }
  if (asks(20, 3)) {
    return normal_axis(plane());
  }
  if (asks(20, 4)) {
    return modal_.spindle_speed;
  }
  if (asks(20, 9) && modal_.feed.mode == FeedMode::per_minute) {
    return units::to_mm_min(modal_.feed.value);
  }
  if (asks(50, 2)) {
    return tools_.radius_of(fmt::format("{}", index));
  }
  if (asks(200, 1)) {
    return modal_.tool_radius;
  }
  if (asks(220, 2) && axis >= 0) {
    return coordinates_.transformations().shift()[axis];
  }
  if (asks(270, 1) && axis >= 0) {
    return contour_.position()[axis];
  }
  return std::nullopt;
}

void SystemData::assign(const QName& result, double group, double number, double index,
                        std::uint32_t column) {
  const std::optional<double> value = this->value(group, number, index);
  const bool asks_position = value && group == 270;
  if (!value) {
    report(Severity::warning, "system-data", 0, column, [&] {
      return Text{
          message(NC_("core", "FN 18 reads ID{} NR{} IDX{}, which depends on the machine"), group, number,
                  index),
          message(NC_("core", "{} is set to 0; assign the value of your machine instead"), result.text())};
    });
  } else if (asks_position && !targets_.was_programmed(static_cast<int>(index) - 1)) {
    report(Severity::warning, "system-data", static_cast<int>(index), column, [&] {
      return Text{message(NC_("core", "FN 18 reads the position of {} before the program has moved it"),
                          "XYZ"[static_cast<int>(index) - 1]),
                  message(NC_("core",
                              "{} is set to the start position, which is assumed as zero; assign the value "
                              "of your machine instead"),
                          result.text())};
    });
  }
  parameters().set(result, value.value_or(0));
}

}  // namespace feedscope::heidenhain
