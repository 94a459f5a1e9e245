#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace feedscope::ui {

/// A text with places %1, %2, ... in their order, as core writes them with fmt::format(): "axis %1 moves to
/// %2". Each place stands for at least one character, the earlier ones for as few as possible.
class TextPattern {
 public:
  /// One place: what stands in it.
  struct Part {
    QString text;
    bool is_program_text = false;  ///< in quotation marks, or directly after a letter, a digit or a place
  };

  explicit TextPattern(const QString& text);

  /// What stands in the places of `text`; none if it is not of this pattern.
  std::optional<std::vector<Part>> match(const QString& text) const;

  /// First character of what is before the first place; none if a place is first.
  std::optional<QChar> beginning() const;

  /// Characters that are not of places.
  qsizetype fixed_size() const { return fixed_size_; }

  /// `translation`, which has the same places in any order, with `parts` in them.
  static QString fill(const QString& translation, const std::vector<QString>& parts);

 private:
  std::vector<QString> fixed_;  ///< before, between and behind the places
  qsizetype fixed_size_ = 0;
};

}  // namespace feedscope::ui
