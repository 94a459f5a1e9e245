#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace feedscope::ui {

/// A text with places %1, %2, ... in order, as core writes them with fmt::format(): "axis %1 moves to %2".
/// Each place matches at least one character, earlier places as few as possible.
class TextPattern {
 public:
  /// The text in one place.
  struct Part {
    QString text;
    bool is_program_text = false;  ///< in quotation marks, or directly after a letter, a digit or a place
  };

  explicit TextPattern(const QString& text);

  /// The texts in the places of `text`; none if it does not match the pattern.
  std::optional<std::vector<Part>> match(const QString& text) const;

  /// First character before the first place; none if the pattern begins with a place.
  std::optional<QChar> beginning() const;

  /// Characters outside the places.
  qsizetype fixed_size() const { return fixed_size_; }

  /// `translation`, which has the same places in any order, filled with `parts`.
  static QString fill(const QString& translation, const std::vector<QString>& parts);

 private:
  std::vector<QString> fixed_;  ///< before, between and after the places
  qsizetype fixed_size_ = 0;
};

}  // namespace feedscope::ui
