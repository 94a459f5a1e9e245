#include "core/program/heidenhain/language/labels.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

std::string Labels::read(Scanner& scanner) const {
  const std::uint32_t column = scanner.column();
  if (scanner.take('"')) {
    const std::string_view rest = scanner.text().substr(scanner.at());
    const std::size_t end = rest.find('"');
    if (end == std::string_view::npos || end == 0) {
      throw ReadFault{"label", column, NC_("core", "the name of the label is not closed, or empty"),
                      NC_("core", "write it as \"NAME\"")};
    }
    scanner.move_to(scanner.at() + end + 1);
    return fmt::format("\"{}\"", rest.substr(0, end));
  }
  const std::size_t before = scanner.at();
  if (const auto name = take_parameter(scanner); name && name->kind == QName::Kind::text) {
    return fmt::format("\"{}\"", parameters().text(name->number));
  }
  scanner.move_to(before);
  const double number = read_value(scanner);
  if (!(number >= 0) || number != std::floor(number) || number > 65535) {
    throw ReadFault{"label", column, message(NC_("core", "{} is not a label"), number),
                    NC_("core", "write a whole number from 1 to 65535 or a name in quotes")};
  }
  return fmt::format("{}", number);
}

const Labels::Lines& Labels::of_text() {
  const auto [found, is_new] = texts_.try_emplace(&lines().text());
  if (is_new) {
    for (std::uint32_t line = 1; line <= lines().text().line_count(); ++line) {
      try {
        const std::string label = of_line_(lines().text().line(line));
        if (!label.empty() && !found->second.try_emplace(label, line).second) {
          machining_.log.add(Severity::warning, "label", 1, {line, 0, lines().place(0).file}, [&] {
            return Text{message(NC_("core", "label {} is defined twice"), label),
                        NC_("core", "the first one is used; a control refuses such a program")};
          });
        }
      } catch (const ReadFault&) {
        // Reported when the line itself runs.
      }
    }
  }
  return found->second;
}

std::optional<std::uint32_t> Labels::line_of(const std::string& label, std::uint32_t column) {
  const Lines& known = of_text();
  const auto found = known.find(label);
  if (found != known.end()) {
    return found->second;
  }
  report(Severity::error, "label-missing", 0, column, [&] {
    return Text{message(NC_("core", "label {} does not exist"), label),
                NC_("core", "the jump or call is skipped")};
  });
  return std::nullopt;
}

}  // namespace feedscope::heidenhain
