#include "ui/program_text/text_search.h"

#include <algorithm>

namespace feedscope::ui {

std::shared_ptr<const FoundLines> FoundLines::find(const ProgramText& text, const LineFinder& finder,
                                                   const Progress& progress) {
  auto found = std::make_shared<FoundLines>();
  const std::uint32_t lines = text.line_count();
  found->lines_.resize(lines);
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < lines; ++i) {
    if (i % group == 0) {
      found->before_.push_back(count);
      if (progress.cancelled()) {
        return nullptr;
      }
    }
    const std::size_t here = finder.count_in(text, i + 1);
    found->lines_[i] = here > 0;
    count += here;
  }
  found->before_.push_back(count);
  return found;
}

std::uint32_t FoundLines::next_line(std::uint32_t line) const {
  const std::size_t from = std::max(line, 1U) - std::size_t{1};
  const std::size_t here = from / group;
  if (from >= lines_.size()) {
    return beyond();
  }
  const auto in_group = [this](std::size_t first, std::size_t last_group) {
    const std::size_t end = std::min<std::size_t>((last_group + 1) * group, lines_.size());
    const auto hit = std::find(lines_.begin() + static_cast<std::ptrdiff_t>(first),
                               lines_.begin() + static_cast<std::ptrdiff_t>(end), true);
    return static_cast<std::size_t>(hit - lines_.begin());
  };
  if (const std::size_t hit = in_group(from, here); hit / group == here && hit < lines_.size()) {
    return static_cast<std::uint32_t>(hit) + 1;
  }
  const auto more = std::upper_bound(before_.begin() + static_cast<std::ptrdiff_t>(here) + 1, before_.end(),
                                     before_[here + 1]);
  if (more == before_.end()) {
    return beyond();
  }
  const auto next_group = static_cast<std::size_t>(more - before_.begin()) - 1;
  return static_cast<std::uint32_t>(in_group(next_group * group, next_group)) + 1;
}

std::uint32_t FoundLines::previous_line(std::uint32_t line) const {
  const std::size_t to = std::min<std::size_t>(line, lines_.size());
  const std::size_t here = to / group;
  for (std::size_t i = to; i > here * group; --i) {
    if (lines_[i - 1]) {
      return static_cast<std::uint32_t>(i);
    }
  }
  const auto reached = std::lower_bound(before_.begin(), before_.end(), before_[here]);
  const auto end = static_cast<std::size_t>(reached - before_.begin()) * group;
  for (std::size_t i = end; i > 0; --i) {  // at most one group: the last one with a hit ends here
    if (lines_[i - 1]) {
      return static_cast<std::uint32_t>(i);
    }
  }
  return 0;
}

std::uint64_t FoundLines::count_before(std::uint32_t line, const ProgramText& text,
                                       const LineFinder& finder) const {
  const std::uint32_t to =
      std::min<std::uint32_t>(std::max(line, 1U) - 1, static_cast<std::uint32_t>(lines_.size()));
  std::uint64_t count = before_[to / group];
  for (std::uint32_t i = to / group * group; i < to; ++i) {
    count += lines_[i] ? finder.count_in(text, i + 1) : 0;
  }
  return count;
}

void TextSearch::set_text(const ProgramText& text) {
  text_ = text;
  start();
}

void TextSearch::set_query(const SearchQuery& query) {
  if (query != query_) {
    query_ = query;
    finder_ = LineFinder(query);
    start();
  }
}

void TextSearch::start() {
  found_ = nullptr;
  searching_ = finder_.can_find() && text_.line_count() > 0;
  if (!searching_) {
    job_.cancel();
  } else {
    job_.start([text = text_, finder = finder_](
                   JobControl& control) { return FoundLines::find(text, finder, control.progress); },
               [this](const JobOutcome<std::shared_ptr<const FoundLines>>& outcome) {
                 if (!outcome.cancelled()) {
                   found_ = outcome.result.value_or(nullptr);
                   searching_ = false;
                   emit changed();
                 }
               });
  }
  emit changed();
}

std::optional<TextRange> TextSearch::at_or_after(TextPlace place) const {
  if (found_ == nullptr || found_->count() == 0) {
    return std::nullopt;
  }
  for (const TextRange& hit : hits_in(place.line)) {
    if (hit.begin >= place) {
      return hit;
    }
  }
  const std::uint32_t next = found_->next_line(place.line + 1);
  return hits_in(next <= text_.line_count() ? next : found_->next_line(1)).front();
}

std::optional<TextRange> TextSearch::before(TextPlace place) const {
  if (found_ == nullptr || found_->count() == 0) {
    return std::nullopt;
  }
  const std::vector<TextRange> here = hits_in(place.line);
  const auto after = std::ranges::find_if(here, [&](const TextRange& hit) { return hit.begin >= place; });
  if (after != here.begin()) {
    return *(after - 1);
  }
  const std::uint32_t previous = found_->previous_line(place.line - 1);
  return hits_in(previous > 0 ? previous : found_->previous_line(text_.line_count())).back();
}

std::uint64_t TextSearch::number_of(TextRange hit) const {
  if (found_ == nullptr) {
    return 0;
  }
  const std::vector<TextRange> here = hits_in(hit.begin.line);
  const auto place = std::ranges::find(here, hit);
  return place == here.end() ? 0
                             : found_->count_before(hit.begin.line, text_, finder_) +
                                   static_cast<std::uint64_t>(place - here.begin()) + 1;
}

}  // namespace feedscope::ui
