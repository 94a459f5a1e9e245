#include "ui/language/text_pattern.h"

#include <utility>

namespace feedscope::ui {

namespace {

bool is_place(const QString& text, qsizetype at) {
  return text[at] == '%' && at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9';
}

/// "X%1", "R%1", "AR=%1", "'%1'", "%1%2": words and names, whose numbers are not localised.
bool touches_program_text(const QString& before, bool is_first) {
  if (before.isEmpty()) {
    return !is_first;
  }
  const QChar last = before.back();
  return last.isLetterOrNumber() || QStringLiteral("=#<'\"_").contains(last);
}

}  // namespace

TextPattern::TextPattern(const QString& text) {
  QString fixed;
  for (qsizetype at = 0; at < text.size(); ++at) {
    if (is_place(text, at)) {
      fixed_.push_back(std::exchange(fixed, {}));
      ++at;
    } else {
      fixed += text[at];
      ++fixed_size_;
    }
  }
  fixed_.push_back(fixed);
}

std::optional<QChar> TextPattern::beginning() const {
  return fixed_.front().isEmpty() ? std::nullopt : std::optional(fixed_.front().front());
}

std::optional<std::vector<TextPattern::Part>> TextPattern::match(const QString& text) const {
  const auto places = static_cast<qsizetype>(fixed_.size()) - 1;
  if (places == 0) {
    return text == fixed_.front() ? std::optional(std::vector<Part>()) : std::nullopt;
  }
  if (text.size() < fixed_size_ + places || !text.startsWith(fixed_.front()) ||
      !text.endsWith(fixed_.back())) {
    return std::nullopt;
  }
  std::vector<Part> parts;
  qsizetype from = fixed_.front().size();
  const qsizetype end = text.size() - fixed_.back().size();
  qsizetype quotation_marks = 0;
  for (qsizetype i = 0; i < places; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const qsizetype to = i + 1 == places ? end : text.indexOf(fixed_[k + 1], from + 1);
    if (to <= from || to > end) {
      return std::nullopt;
    }
    quotation_marks += fixed_[k].count('"');
    parts.push_back(
        {text.mid(from, to - from), quotation_marks % 2 == 1 || touches_program_text(fixed_[k], i == 0)});
    from = to + fixed_[k + 1].size();
  }
  return parts;
}

QString TextPattern::fill(const QString& translation, const std::vector<QString>& parts) {
  QString filled;
  for (qsizetype at = 0; at < translation.size(); ++at) {
    const auto part =
        is_place(translation, at) ? static_cast<std::size_t>(translation[at + 1].digitValue()) : 0;
    if (part >= 1 && part <= parts.size()) {
      filled += parts[part - 1];
      ++at;
    } else {
      filled += translation[at];
    }
  }
  return filled;
}

}  // namespace feedscope::ui
