#include "core/program/sinumerik/geometry/coordinate_value.h"

#include <array>
#include <optional>
#include <string_view>

namespace feedscope::sinumerik {

namespace {

struct Kind {
  std::string_view name;
  Reading reading;
  Across across = Across::modal;
};

constexpr auto kinds = std::to_array<Kind>({{"AC", Reading::absolute},
                                            {"IC", Reading::incremental},
                                            {"DC", Reading::shortest},
                                            {"ACP", Reading::positive},
                                            {"ACN", Reading::negative},
                                            {"DAC", Reading::absolute, Across::diameter},
                                            {"DIC", Reading::incremental, Across::diameter},
                                            {"RAC", Reading::absolute, Across::radius},
                                            {"RIC", Reading::incremental, Across::radius}});

}  // namespace

BlockWords::Value read_coordinate(Values& values, Scanner& scanner, std::uint32_t column) {
  if (const std::optional<double> number = Values::plain_number(scanner)) {
    return {.value = *number, .column = column, .reading = Reading::modal};
  }
  for (const Kind& kind : kinds) {
    if (scanner.take_name(kind.name)) {
      require(scanner, '(');
      const double value = values.read_bounded(scanner);
      require(scanner, ')');
      return {.value = value, .column = column, .reading = kind.reading, .across = kind.across};
    }
  }
  return {.value = values.read_bounded(scanner), .column = column, .reading = Reading::modal};
}

}  // namespace feedscope::sinumerik
