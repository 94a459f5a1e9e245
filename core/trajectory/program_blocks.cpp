#include "core/trajectory/program_blocks.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/roots.h"

namespace feedscope {
namespace {

/// A part of a line shorter than this [mm] is omitted.
constexpr double least_part = 1e-12;

/// Cuts elements and pieces of a run where its merged blocks join.
class BlockCutter {
 public:
  BlockCutter(const Trajectory& run, const Toolpath& programmed, const CompactedPath& merged)
      : run_(run), path_(run.path()), programmed_(programmed), merged_(merged) {
    parts_.reserve(path_.size() + programmed.segments.size() - merged.path.segments.size());
    pieces_.reserve(run.pieces().size());
  }

  void cut() {
    for (element_ = 0; element_ < path_.size(); ++element_) {
      first_part_ = parts_.size();
      first_block_ = merged_.first[path_.segment(element_)];
      last_block_ = merged_.first[path_.segment(element_) + std::size_t{1}] - 1;
      if (first_block_ == last_block_) {
        add_part(first_block_, 0);
      } else {
        cut_merged();
      }
      pass_pieces();
    }
  }

  const std::vector<ElementPart>& parts() const { return parts_; }
  std::vector<Piece> take_pieces() { return std::move(pieces_); }

 private:
  void add_part(std::uint32_t block, double q) { parts_.push_back({element_, block, q}); }

  void cut_merged() {
    switch (path_.kind(element_)) {
      case ElementKind::line:
        cut_line();
        break;
      case ElementKind::filtered:
        cut_filtered();
        break;
      case ElementKind::curve:
        add_part(block_at(path_.curve(element_).start), 0);
        break;
      default:  // the corner at its end
        add_part(last_block_, 0);
    }
  }

  /// Position of `point` along the line of the element, from the start of the line [mm].
  double along(const Vec3& point) const {
    const std::size_t line = path_.base_segment_of(element_);
    return (point - path_.base().start_of(line)).dot(path_.base().tangent_at_start(line));
  }

  std::uint32_t block_at(const Vec3& point) const {
    std::uint32_t block = first_block_;
    while (block < last_block_ && along(programmed_.segments[block].end) <= along(point)) {
      ++block;
    }
    return block;
  }

  void cut_line() {
    const double offset = path_.line_offset(element_);
    const double length = path_.length(element_);
    double q = 0;
    for (std::uint32_t block = first_block_; block <= last_block_; ++block) {
      const double end =
          block == last_block_ ? length : std::min(along(programmed_.segments[block].end) - offset, length);
      if (end - q > least_part) {
        add_part(block, q);
        q = end;
      }
    }
    if (parts_.size() == first_part_) {
      add_part(last_block_, 0);
    }
  }

  /// Blocks of filtered motion end where it has covered as much of the line as the program's points have.
  void cut_filtered() {
    constexpr int halvings = 50;
    const std::vector<Piece>& pieces = run_.pieces();
    std::size_t piece = piece_;
    add_part(first_block_, 0);
    times_.assign(1, 0.0);
    if (piece == pieces.size() || pieces[piece].element != element_) {
      return;
    }
    std::size_t last = piece;
    while (last + 1 < pieces.size() && pieces[last + 1].element == element_) {
      ++last;
    }
    const FilteredMotion& motion = run_.motion_of(element_);
    const auto passed = [&](double time) {
      return along(filters_.motion_at(motion.train(), time - motion.start()).position);
    };
    double from = pieces[piece].time;
    const double end = run_.piece_end(last);
    for (std::uint32_t block = first_block_; block < last_block_; ++block) {
      const double border = along(programmed_.segments[block].end);
      if (passed(end) < border) {
        return;
      }
      const double time = halve({from, end}, halvings, [&](double t) { return passed(t) < border; }).low;
      if (!(time > from)) {
        parts_.back().block = block + 1;
        continue;
      }
      while (piece < last && run_.piece_end(piece) <= time) {
        ++piece;
      }
      add_part(block + 1, run_.filtered_q(piece, time - pieces[piece].time, filters_));
      times_.push_back(time);
      from = time;
    }
  }

  void pass_pieces() {
    const bool filtered = path_.kind(element_) == ElementKind::filtered && parts_.size() > first_part_ + 1;
    std::size_t part = first_part_;
    for (; piece_ < run_.pieces().size() && run_.pieces()[piece_].element == element_; ++piece_) {
      const Piece& piece = run_.pieces()[piece_];
      const auto next_begins = [&](double limit) {
        return part + 1 < parts_.size() &&
               (filtered ? times_[part + 1 - first_part_] <= limit : parts_[part + 1].q <= limit);
      };
      while (next_begins(filtered ? piece.time : piece.q)) {
        ++part;
      }
      add_piece(piece, part);
      while (filtered && next_begins(run_.piece_end(piece_)) &&
             times_[part + 1 - first_part_] < run_.piece_end(piece_)) {
        ++part;
        Piece rest = piece;
        rest.time = times_[part - first_part_];
        rest.q = parts_[part].q;
        add_piece(rest, part);
      }
    }
  }

  void add_piece(Piece piece, std::size_t part) {
    piece.q = std::max(piece.q - parts_[part].q, 0.0);
    piece.element = static_cast<std::uint32_t>(part);
    pieces_.push_back(piece);
  }

  const Trajectory& run_;
  const BlendedPath& path_;
  const Toolpath& programmed_;
  const CompactedPath& merged_;

  std::uint32_t element_ = 0;      ///< of the run, current
  std::uint32_t first_block_ = 0;  ///< of the blocks merged into its block
  std::uint32_t last_block_ = 0;
  std::size_t first_part_ = 0;  ///< of the element
  std::size_t piece_ = 0;       ///< of the run, next
  FilterWalk filters_;
  std::vector<double> times_;  ///< at which the parts of a filtered element begin; 0 for the first [s]

  std::vector<ElementPart> parts_;
  std::vector<Piece> pieces_;
};

/// `merged`, combined with the blocks that the run itself joined.
std::shared_ptr<const CompactedPath> with_chords_of(const BlendedPath& path,
                                                    const std::shared_ptr<const CompactedPath>& merged) {
  const std::shared_ptr<const CompactedPath>& chords = path.compacted();
  if (chords == nullptr) {
    return merged;
  }
  auto both = std::make_shared<CompactedPath>(*chords);
  std::ranges::transform(chords->first, both->first.begin(),
                         [&](std::uint32_t block) { return merged->first[block]; });
  return both;
}

}  // namespace

Trajectory on_program_blocks(const Trajectory& run, std::shared_ptr<const Toolpath> programmed,
                             const std::shared_ptr<const CompactedPath>& merged) {
  BlockCutter cutter(run, *programmed, *merged);
  cutter.cut();
  const Trajectory::Content& own = run.content();
  Trajectory::Content content{
      run.path().cut(std::move(programmed), with_chords_of(run.path(), merged), cutter.parts()),
      cutter.take_pieces(),
      own.duration,
      own.axis_velocity,
      std::max(own.compaction_error, merged->deviation),
      own.motions,
      own.filtered_corners};
  for (std::uint32_t& element : content.filtered_corners) {
    const auto after = std::ranges::upper_bound(cutter.parts(), element, {}, &ElementPart::element);
    element = static_cast<std::uint32_t>(after - cutter.parts().begin()) - 1;
  }
  return Trajectory(std::move(content));
}

}  // namespace feedscope
