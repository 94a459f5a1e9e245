#include "core/program/heidenhain/geometry/feeds.h"

namespace feedscope::heidenhain {

void Feeds::report_value(const MotionWords& words) const {
  report(Severity::error, "feed-value", 0, words.feed_column, [&] {
    return Text{message(NC_("core", "feed F{} is zero or negative"), words.feed),
                modal_.feed.value > 0
                    ? NC_("core", "the last valid feed stays in force; write a feed above zero")
                    : NC_("core", "feed moves run as fast as the axes allow; write a feed above zero")};
  });
}

void Feeds::apply(const MotionWords& words) {
  if (words.feed_word == FeedWord::none || words.feed_word == FeedWord::rapid) {
    return;
  }
  const bool of_tool = words.feed_word == FeedWord::of_tool_call;
  const double written = of_tool ? modal_.tool_feed : words.feed;
  const FeedWord word = of_tool ? modal_.tool_feed_word : words.feed_word;
  if (!(written > 0)) {
    report_value(words);
    return;
  }
  if (word == FeedWord::per_tooth) {
    modal_.feed = {FeedMode::per_tooth, to_mm(written)};
    report(Severity::warning, "tooth-count", 0, words.feed_column, [] {
      return Text{NC_("core", "a feed per tooth without the number of teeth, which is in the tool table"),
                  NC_("core", "one tooth is assumed; write F or FU")};
    });
  } else if (word == FeedWord::per_revolution || per_revolution_) {
    modal_.feed = {FeedMode::per_revolution, to_mm(written)};
  } else {
    modal_.feed = {FeedMode::per_minute, modal_.to_feed(written)};
  }
}

void Feeds::apply_tool_call(FeedWord word, double feed, std::uint32_t column) {
  modal_.tool_feed = feed;
  modal_.tool_feed_word = word;
  MotionWords words;
  words.feed_word = word;
  words.feed = feed;
  words.feed_column = column;
  apply(words);
}

void Feeds::set_per_revolution(bool per_revolution) {
  per_revolution_ = per_revolution;
  modal_.feed = {per_revolution ? FeedMode::per_revolution : FeedMode::per_minute, 0};
}

ContourFeed Feeds::of(const MotionWords& words) const {
  ContourFeed feed = modal_.feed;
  feed.rapid = words.feed_word == FeedWord::rapid;
  return feed;
}

std::optional<ContourFeed> Feeds::alone(const MotionWords& words) {
  if (words.feed_word == FeedWord::none) {
    return std::nullopt;
  }
  const ContourFeed before = modal_.feed;
  apply(words);
  const ContourFeed alone = of(words);
  modal_.feed = before;
  return alone;
}

}  // namespace feedscope::heidenhain
