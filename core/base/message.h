#pragma once

#include <concepts>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace feedscope {

/// An English text for display, marked in place by NC_() so that translators find it. A text with places for
/// arguments, written as for fmt::format(), is a pattern.
struct Translatable {
  const char* english = "";

  constexpr bool empty() const { return *english == 0; }
};

/// `context` is "core". lupdate finds these with -tr-function-alias QT_TRANSLATE_NOOP+=NC_.
#define NC_(context, text)    \
  ::feedscope::Translatable { \
    text                      \
  }

/// A text for display as data: English in files and on the command line, translated in the window and in
/// reports (in_language() of the ui). Texts of the program, names and units are not translated; numbers get
/// the decimal sign of the language; a message that is an argument is translated itself.
class Message {
 public:
  enum class Kind { written, number, pattern };

  Message() = default;
  Message(Translatable text) : text_(text.english), kind_(Kind::pattern) {}  // NOLINT: no arguments

  /// A text that is the same in every language: from a program, a file or another library.
  static Message as_written(std::string text);
  /// Digits with a decimal point.
  static Message number(std::string digits);
  /// A pattern with one argument for each of its places; message() is its usual caller.
  static Message of(Translatable pattern, std::vector<Message> arguments);

  Kind kind() const { return kind_; }
  /// The English pattern, or the written text or number itself.
  const std::string& text() const { return text_; }
  const std::vector<Message>& arguments() const { return arguments_; }
  bool empty() const { return text_.empty(); }
  std::string english() const;

  friend bool operator==(const Message&, const Message&) = default;
  friend bool operator==(const Message& message, std::string_view english) {
    return message.english() == english;
  }

 private:
  std::string text_;
  std::vector<Message> arguments_;
  Kind kind_ = Kind::written;
};

std::ostream& operator<<(std::ostream& stream, const Message& message);

/// Fills the places of `pattern`: "{}" takes the next part, "{1}" the second; the format after a colon is
/// ignored. Without parts, the text itself.
std::string filled(std::string_view pattern, std::span<const std::string> parts);

/// An argument of message(), formatted by its place.
class MessageValue {
 public:
  template <std::integral T>
  MessageValue(T value);                                                // NOLINT: as for fmt::format()
  MessageValue(double value) : real_(value), type_(Type::real) {}       // NOLINT
  MessageValue(float value) : real_(value), type_(Type::short_real) {}  // NOLINT
  MessageValue(char letter) : message_(Message::as_written(std::string(1, letter))) {}       // NOLINT
  MessageValue(Message message) : message_(std::move(message)) {}                            // NOLINT
  MessageValue(Translatable text) : message_(text) {}                                        // NOLINT
  MessageValue(std::string_view text) : message_(Message::as_written(std::string(text))) {}  // NOLINT
  MessageValue(const std::string& text) : message_(Message::as_written(text)) {}             // NOLINT

  /// `place` as in the pattern: "{}", "{:.3f}".
  Message formatted(std::string_view place) const;

 private:
  enum class Type { message, whole, positive, real, short_real };

  Message message_;
  long long whole_ = 0;
  unsigned long long positive_ = 0;
  double real_ = 0;
  Type type_ = Type::message;
};

template <std::integral T>
MessageValue::MessageValue(T value)
    : whole_(std::is_signed_v<T> ? static_cast<long long>(value) : 0),
      positive_(std::is_signed_v<T> ? 0 : static_cast<unsigned long long>(value)),
      type_(std::is_signed_v<T> ? Type::whole : Type::positive) {
  static_assert(!std::is_same_v<T, bool>, "true and false have no translation");
}

/// A pattern with `count` places, counted at compile time.
template <std::size_t count>
struct PatternOf {
  consteval PatternOf(Translatable pattern) : text(pattern) {  // NOLINT: deduces the count
    std::size_t arguments = 0;
    std::size_t next = 0;
    for (const char* at = pattern.english; *at != 0; ++at) {
      if (at[0] == '{' && at[1] == '{') {
        ++at;
      } else if (at[0] == '{') {
        const bool numbered = at[1] >= '0' && at[1] <= '9';
        const std::size_t argument = numbered ? static_cast<std::size_t>(at[1] - '0') : next++;
        arguments = argument + 1 > arguments ? argument + 1 : arguments;
      }
    }
    if (arguments != count) {
      throw "the pattern has another number of places than there are arguments";
    }
  }

  Translatable text;
};

Message message_of(Translatable pattern, std::span<const MessageValue> values);

/// A message of a pattern and its arguments: message(NC_("core", "axis {} moves to {:.3f} mm"), name,
/// position). Numbers are formatted as by fmt::format(). A number directly after a letter or a digit, or in
/// quotation marks, as in "X{}", belongs to a word of the program and keeps its decimal point. Words to be
/// translated are passed as Message or Translatable, texts of the program as std::string.
template <typename... Values>
Message message(PatternOf<sizeof...(Values)> pattern, const Values&... values) {
  static_assert((!std::is_convertible_v<const Values&, const char*> && ...),
                "mark a literal by NC_() if it is translated, or pass a std::string_view if it is not");
  const MessageValue all[]{MessageValue(values)...};
  return message_of(pattern.text, all);
}

/// `what` after its place: "part.toml:3:1: ...". A place is the same in every language.
Message at_place(std::string place, Message what);
/// Reason of the operating system: "No such file or directory".
Message reason_of(const std::error_code& error);

/// "A, B, C".
Message enumerated(std::span<const Message> all);
/// "A", "A and B", "A, B and C".
Message listed(std::span<const Message> all);

}  // namespace feedscope
