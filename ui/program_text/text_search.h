#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "ui/program_text/line_finder.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// In which lines of a program a query is found: one bit a line and a count every few lines, so that a
/// million hits take no more room than one.
class FoundLines {
 public:
  /// Looks at all lines. Null if `progress` was cancelled.
  static std::shared_ptr<const FoundLines> find(const ProgramText& text, const LineFinder& finder,
                                                const Progress& progress);

  std::uint64_t count() const { return before_.back(); }
  /// Whether anything is found in the lines from `first` to `last`, both included.
  bool any(std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t next = next_line(first);
    return next <= last && next < beyond();
  }
  /// Both by the counts of the groups: in logarithmic time. The first line from `line` on with a hit; beyond
  /// the last line if there is none.
  std::uint32_t next_line(std::uint32_t line) const;
  /// The last line up to `line` with a hit; 0 if there is none.
  std::uint32_t previous_line(std::uint32_t line) const;
  /// Hits in the lines before `line`.
  std::uint64_t count_before(std::uint32_t line, const ProgramText& text, const LineFinder& finder) const;

 private:
  static constexpr std::uint32_t group = 64;  ///< lines

  std::uint32_t beyond() const { return static_cast<std::uint32_t>(lines_.size()) + 1; }

  std::vector<bool> lines_;            ///< [n]: line n + 1 has a hit
  std::vector<std::uint64_t> before_;  ///< [g]: hits before group g; the last one: all hits
};

/// A search through a program. The count of all hits is made on another thread; until it is there, what is
/// asked for is not known.
class TextSearch : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void set_text(const ProgramText& text);
  void set_query(const SearchQuery& query);
  const SearchQuery& query() const { return query_; }
  const QString& error() const { return finder_.error(); }

  bool busy() const { return searching_; }
  /// Null while busy, and if nothing is looked for.
  const FoundLines* found() const { return found_.get(); }

  /// The first hit that begins at `place` or later, or else the first one of all.
  std::optional<TextRange> at_or_after(TextPlace place) const;
  /// The last hit that begins before `place`, or else the last one of all.
  std::optional<TextRange> before(TextPlace place) const;
  /// Its number among all hits, from 1; 0 if it is none.
  std::uint64_t number_of(TextRange hit) const;
  std::vector<TextRange> hits_in(std::uint32_t line) const { return finder_.matches_in(text_, line); }

 signals:
  /// Another query or text, or the count is there.
  void changed();

 private:
  void start();

  ProgramText text_;
  SearchQuery query_;
  LineFinder finder_;
  std::shared_ptr<const FoundLines> found_;
  bool searching_ = false;
  Job<std::shared_ptr<const FoundLines>> job_;
};

}  // namespace feedscope::ui
