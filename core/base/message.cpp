#include "core/base/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace feedscope {

namespace {

/// Calls `fixed(text)` and `place(text, argument)` for the parts of the pattern in order.
template <typename Fixed, typename Place>
void walk(std::string_view pattern, Fixed&& fixed, Place&& place) {
  std::size_t next = 0;
  for (std::size_t at = 0; at < pattern.size();) {
    const char c = pattern[at];
    if ((c == '{' || c == '}') && at + 1 < pattern.size() && pattern[at + 1] == c) {
      fixed(pattern.substr(at, 1));
      at += 2;
      continue;
    }
    const std::size_t end = c == '{' ? pattern.find('}', at) : std::string_view::npos;
    if (end == std::string_view::npos) {
      const std::size_t stop = std::min(pattern.find_first_of("{}", at + 1), pattern.size());
      fixed(pattern.substr(at, stop - at));
      at = stop;
      continue;
    }
    const bool numbered = pattern[at + 1] >= '0' && pattern[at + 1] <= '9';
    const std::size_t argument = numbered ? static_cast<std::size_t>(pattern[at + 1] - '0') : next++;
    place(pattern.substr(at, end + 1 - at), argument);
    at = end + 1;
  }
}

/// Whether the place after this text is in a word or name of a program, whose numbers are not localised:
/// "X{}", "R{}", "AR={}", "'{}'", "{}{}".
bool ends_in_program_text(std::string_view before, bool follows_place) {
  if (before.empty()) {
    return follows_place;
  }
  const char last = before.back();
  const bool letter =
      (last >= 'a' && last <= 'z') || (last >= 'A' && last <= 'Z') || (last >= '0' && last <= '9');
  return letter || std::string_view("=#<'\"_").find(last) != std::string_view::npos;
}

}  // namespace

Message Message::as_written(std::string text) {
  Message made;
  made.text_ = std::move(text);
  return made;
}

Message Message::number(std::string digits) {
  Message made = as_written(std::move(digits));
  made.kind_ = Kind::number;
  return made;
}

Message Message::of(Translatable pattern, std::vector<Message> arguments) {
  Message made(pattern);
  made.arguments_ = std::move(arguments);
  return made;
}

std::string Message::english() const {
  std::vector<std::string> parts;
  parts.reserve(arguments_.size());
  for (const Message& argument : arguments_) {
    parts.push_back(argument.english());
  }
  return filled(text_, parts);
}

std::ostream& operator<<(std::ostream& stream, const Message& message) {
  return stream << message.english();
}

std::string filled(std::string_view pattern, std::span<const std::string> parts) {
  if (parts.empty()) {
    return std::string(pattern);
  }
  std::string text;
  walk(
      pattern, [&](std::string_view fixed) { text += fixed; },
      [&](std::string_view place, std::size_t argument) {
        text += argument < parts.size() ? parts[argument] : place;
      });
  return text;
}

Message MessageValue::formatted(std::string_view place) const {
  switch (type_) {
    case Type::message:
      return message_;
    case Type::whole:
      return Message::number(fmt::vformat(place, fmt::make_format_args(whole_)));
    case Type::positive:
      return Message::number(fmt::vformat(place, fmt::make_format_args(positive_)));
    case Type::short_real:
      return Message::number(fmt::vformat(place, fmt::make_format_args(static_cast<float>(real_))));
    case Type::real:
      break;
  }
  return Message::number(fmt::vformat(place, fmt::make_format_args(real_)));
}

Message message_of(Translatable pattern, std::span<const MessageValue> values) {
  std::vector<Message> arguments(values.size());
  std::string before;
  bool follows_place = false;
  std::size_t quotation_marks = 0;
  walk(
      pattern.english,
      [&](std::string_view fixed) {
        before += fixed;
        quotation_marks += static_cast<std::size_t>(std::ranges::count(fixed, '"'));
      },
      [&](std::string_view place, std::size_t argument) {
        const bool numbered = place[1] >= '0' && place[1] <= '9';
        Message made = values[argument].formatted("{" + std::string(place.substr(numbered ? 2 : 1)));
        const bool of_program = quotation_marks % 2 == 1 || ends_in_program_text(before, follows_place);
        arguments[argument] = made.kind() == Message::Kind::number && of_program
                                  ? Message::as_written(made.text())
                                  : std::move(made);
        before.clear();
        follows_place = true;
      });
  return Message::of(pattern, std::move(arguments));
}

Message at_place(std::string place, Message what) {
  return Message::of({"{}: {}"}, {Message::as_written(std::move(place)), std::move(what)});
}

Message reason_of(const std::error_code& error) {
  if (error == std::errc::no_such_file_or_directory) {
    return NC_("core", "No such file or directory");
  }
  if (error == std::errc::permission_denied) {
    return NC_("core", "Permission denied");
  }
  if (error == std::errc::is_a_directory) {
    return NC_("core", "Is a directory");
  }
  if (error == std::errc::no_space_on_device) {
    return NC_("core", "No space left on device");
  }
  return Message::as_written(error.message());
}

Message enumerated(std::span<const Message> all) {
  Message list = all.empty() ? Message() : all.front();
  for (std::size_t i = 1; i < all.size(); ++i) {
    list = message(NC_("core", "{}, {}"), list, all[i]);
  }
  return list;
}

Message listed(std::span<const Message> all) {
  const Message list = enumerated(all.first(all.empty() ? 0 : std::max<std::size_t>(all.size() - 1, 1)));
  return all.size() > 1 ? message(NC_("core", "{} and {}"), list, all.back()) : list;
}

}  // namespace feedscope
