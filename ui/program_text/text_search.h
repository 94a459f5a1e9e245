#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "ui/program_text/line_finder.h"
#include "ui/shared/job.h"

namespace feedscope::ui {

/// The lines of a program with hits of a query: one bit for each line and a count every few lines, so that a
/// million hits take no more memory than one.
class FoundLines {
 public:
  /// Searches all lines. Null if `progress` was cancelled.
  static std::shared_ptr<const FoundLines> find(const ProgramText& text, const LineFinder& finder,
                                                const Progress& progress);

  std::uint64_t count() const { return before_.back(); }
  /// Whether there is a hit in the lines from `first` to `last`, both included.
  bool any(std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t next = next_line(first);
    return next <= last && next < beyond();
  }
  /// The first line from `line` on with a hit; beyond the last line if there is none. This and
  /// previous_line() use the counts of the groups, in logarithmic time.
  std::uint32_t next_line(std::uint32_t line) const;
  /// The last line up to `line` with a hit; 0 if there is none.
  std::uint32_t previous_line(std::uint32_t line) const;
  /// Number of hits in the lines before `line`.
  std::uint64_t count_before(std::uint32_t line, const ProgramText& text, const LineFinder& finder) const;

 private:
  static constexpr std::uint32_t group = 64;  ///< lines

  std::uint32_t beyond() const { return static_cast<std::uint32_t>(lines_.size()) + 1; }

  std::vector<bool> lines_;            ///< [n]: line n + 1 has a hit
  std::vector<std::uint64_t> before_;  ///< [g]: hits before group g; the last one: all hits
};

/// A search through a program. Another thread counts all hits; until then, results are unknown.
class TextSearch : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void set_text(const ProgramText& text);
  void set_query(const SearchQuery& query);
  const SearchQuery& query() const { return query_; }
  const QString& error() const { return finder_.error(); }

  bool busy() const { return searching_; }
  /// Null while busy, and without a query.
  const FoundLines* found() const { return found_.get(); }

  /// The first hit that begins at `place` or later, or else the first of all.
  std::optional<TextRange> at_or_after(TextPlace place) const;
  /// The last hit that begins before `place`, or else the last of all.
  std::optional<TextRange> before(TextPlace place) const;
  /// Its number among all hits, from 1; 0 if it is not a hit.
  std::uint64_t number_of(TextRange hit) const;
  std::vector<TextRange> hits_in(std::uint32_t line) const { return finder_.matches_in(text_, line); }

 signals:
  /// The query or the text has changed, or the count is complete.
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
