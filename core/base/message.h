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

/// An English text of the source that people see, marked where it stands by NC_() so that translators find
/// it. With places for arguments, as fmt::format() has them, it is a pattern.
struct Translatable {
  const char* english = "";

  constexpr bool empty() const { return *english == 0; }
};

/// `context` is "core"; lupdate reads it where it is called with -tr-function-alias QT_TRANSLATE_NOOP+=NC_.
#define NC_(context, text)    \
  ::feedscope::Translatable { \
    text                      \
  }

/// A text for people as data: English in files and on the command line, translated where a window shows it.
/// Texts of the program, names and units stay as they are written, numbers get the decimal sign of the
/// language, and messages within a message are translated like itself.
class Message {
 public:
  enum class Kind { written, number, pattern };

  Message() = default;
  Message(Translatable text) : text_(text.english), kind_(Kind::pattern) {}  // NOLINT: its words are ours

  /// A text that is the same in every language: of a program, of a file, of a library.
  static Message as_written(std::string text);
  /// Digits as English shows them.
  static Message number(std::string digits);
  /// A pattern with an argument for each of its places, see message().
  static Message of(Translatable pattern, std::vector<Message> arguments);

  Kind kind() const { return kind_; }
  /// The pattern in English; of a written text or a number the text itself.
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

/// `pattern` with `parts` in its places: "{}" takes the next, "{1}" the second; what follows a colon in a
/// place is skipped. Without parts it is the text itself.
std::string filled(std::string_view pattern, std::span<const std::string> parts);

/// What message() takes as an argument, with the format of its place.
class MessageValue {
 public:
  template <std::integral T>
  MessageValue(T value);                                                // NOLINT: as fmt::format() takes it
  MessageValue(double value) : real_(value), type_(Type::real) {}       // NOLINT
  MessageValue(float value) : real_(value), type_(Type::short_real) {}  // NOLINT
  MessageValue(char letter) : message_(Message::as_written(std::string(1, letter))) {}       // NOLINT
  MessageValue(Message message) : message_(std::move(message)) {}                            // NOLINT
  MessageValue(Translatable text) : message_(text) {}                                        // NOLINT
  MessageValue(std::string_view text) : message_(Message::as_written(std::string(text))) {}  // NOLINT
  MessageValue(const std::string& text) : message_(Message::as_written(text)) {}             // NOLINT

  /// `place` as it stands in the pattern: "{}", "{:.3f}".
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
  static_assert(!std::is_same_v<T, bool>, "true and false are no words of a message");
}

/// A pattern with `count` places, which the compiler counts.
template <std::size_t count>
struct PatternOf {
  consteval PatternOf(Translatable pattern) : text(pattern) {  // NOLINT: a pattern is one of some count
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

/// message(NC_("core", "axis {} moves to {:.3f} mm"), name, position). Numbers are formatted as by
/// fmt::format(); directly after a letter, a digit or in quotation marks, as in "X{}", they are part of a
/// word of the program, which stays as it is written. Texts of ours are Messages or Translatables themselves.
template <typename... Values>
Message message(PatternOf<sizeof...(Values)> pattern, const Values&... values) {
  static_assert((!std::is_convertible_v<const Values&, const char*> && ...),
                "of bare words nobody knows whether they are to be translated: NC_() or std::string_view");
  const MessageValue all[]{MessageValue(values)...};
  return message_of(pattern.text, all);
}

/// "part.toml:3:1: " and what is wrong there: a place is written the same in every language.
Message at_place(std::string place, Message what);
/// Why the system refuses: "No such file or directory".
Message reason_of(const std::error_code& error);

/// "A, B, C".
Message enumerated(std::span<const Message> all);
/// "A", "A and B", "A, B and C".
Message listed(std::span<const Message> all);

}  // namespace feedscope
