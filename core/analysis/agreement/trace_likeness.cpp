#include "core/analysis/agreement/trace_likeness.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "core/analysis/agreement/path_shape.h"

namespace feedscope {
namespace {

constexpr double extent_share = 0.03;  // by which the extents of the same shape may differ
constexpr double shape_share = 0.01;   // of the size: mean distance within which two shapes are the same

struct Likeness {
  std::array<int, 3> order{0, 1, 2};  ///< recorded axis for each axis of the program
  double scale = 1;                   ///< recorded size over that of the program
  Vec3 mirror = Vec3::Ones();
  bool backwards = false;
  double distance = 0;  ///< [mm]

  int changes() const {
    return static_cast<int>(order != std::array{0, 1, 2}) + static_cast<int>(scale != 1) +
           static_cast<int>(mirror != Vec3::Ones()) + static_cast<int>(backwards);
  }
};

Vec3 ordered(const std::array<int, 3>& order, const Vec3& place) {
  return {place[order[0]], place[order[1]], place[order[2]]};
}

bool same_extent(const Vec3& a, const Vec3& wanted) {
  return (a - wanted).cwiseAbs().maxCoeff() <= extent_share * wanted.norm();
}

/// Simplest transformation that turns a recorded shape into that of the program; of equally simple ones the
/// nearest.
class LikenessSearch {
 public:
  LikenessSearch(const ProgrammedCourse& course, const MotionRecord& record) : bounds_(course.bounds()) {
    std::vector<Vec3> path;
    for (std::size_t i = 0; i < course.size(); ++i) {
      path.push_back(course.point(i));
    }
    wanted_ = bounds_.max - bounds_.min;
    recorded_bounds_ = bounds_of(record.place);
    extent_ = recorded_bounds_.max - recorded_bounds_.min;
    shape_ = shape_of(path, wanted_.norm() * 1e-3);
    recorded_ = shape_of(record.place, extent_.norm() * 1e-3);
  }

  std::optional<Likeness> simplest() {
    if (shape_.empty() || recorded_.empty()) {
      return std::nullopt;
    }
    constexpr std::array scales{1.0, 1e3, 1e-3, 25.4, 1 / 25.4};
    Likeness candidate;
    do {
      for (const double scale : scales) {
        candidate.scale = scale;
        if (same_extent(ordered(candidate.order, extent_) / scale, wanted_)) {
          for (const bool backwards : {false, true}) {
            candidate.backwards = backwards;
            try_signs(candidate);
          }
        }
      }
    } while (std::ranges::next_permutation(candidate.order).found);
    return best_;
  }

 private:
  void try_signs(Likeness candidate) {
    for (unsigned signs = 0; signs < 8; ++signs) {
      bool seen = true;
      for (int axis = 0; axis < 3; ++axis) {
        const bool mirrored = (signs >> static_cast<unsigned>(axis) & 1U) != 0;
        candidate.mirror[axis] = mirrored ? -1 : 1;
        seen = seen && (!mirrored || wanted_[axis] > extent_share * wanted_.norm());
      }
      if (!seen) {
        continue;  // an axis without extent has no sign
      }
      candidate.distance = distance(candidate);
      const auto key = [](const Likeness& one) { return std::tuple(one.changes(), one.distance); };
      if (candidate.distance <= shape_share * wanted_.norm() && (!best_ || key(candidate) < key(*best_))) {
        best_ = candidate;
      }
    }
  }

  double distance(const Likeness& likeness) const {
    const Vec3 middle = (bounds_.min + bounds_.max) / 2;
    const Vec3 recorded_middle =
        ordered(likeness.order, (recorded_bounds_.min + recorded_bounds_.max) / 2) / likeness.scale;
    std::vector<Vec3> moved;
    moved.reserve(recorded_.size());
    for (const Vec3& place : recorded_) {
      moved.emplace_back(middle + likeness.mirror.cwiseProduct(
                                      ordered(likeness.order, place) / likeness.scale - recorded_middle));
    }
    if (likeness.backwards) {
      std::ranges::reverse(moved);
    }
    return mean_distance(shape_, moved);
  }

  Bounds bounds_;
  Bounds recorded_bounds_;
  Vec3 wanted_ = Vec3::Zero();
  Vec3 extent_ = Vec3::Zero();
  std::vector<Vec3> shape_;
  std::vector<Vec3> recorded_;
  std::optional<Likeness> best_;
};

Diagnostic remark(std::string code, Message what, Message hint) {
  return {.severity = Severity::warning,
          .line = 0,
          .column = 0,
          .code = std::move(code),
          .message = std::move(what),
          .hint = std::move(hint)};
}

}  // namespace

std::vector<Diagnostic> likeness_remarks(const ProgrammedCourse& course, const MotionRecord& record) {
  std::vector<Diagnostic> remarks;
  const std::optional<Likeness> found = LikenessSearch(course, record).simplest();
  if (!found) {
    return remarks;
  }
  if (found->order != std::array{0, 1, 2}) {
    const auto name = [&](std::size_t axis) {
      return coordinate_names[static_cast<std::size_t>(found->order[axis])];
    };
    remarks.push_back(remark(
        "trace-columns",
        message(NC_("core",
                    "the trace fits this program with its axes in another order: its {} as X, its {} as Y, "
                    "its {} as Z"),
                name(0), name(1), name(2)),
        NC_("core",
            "name the columns in this order; for X and Y exchanged, as --columns time=1,x=3,y=2,z=4")));
  }
  if (found->scale != 1) {
    const std::string_view unit = found->scale == 1e3    ? "um"
                                  : found->scale == 1e-3 ? "m"
                                  : found->scale > 1     ? "mm"
                                                         : "in";
    remarks.push_back(remark(
        "trace-columns",
        message(NC_("core", "the trace has the shape of this program, {:.4g} times as large"), found->scale),
        message(NC_("core", "give each of its axes the unit, as --columns time=1,x=2:{0},y=3:{0},z=4:{0}"),
                unit)));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (found->mirror[axis] < 0) {
      remarks.push_back(
          remark("trace-columns",
                 message(NC_("core", "the trace fits this program with {} in the other direction"),
                         coordinate_names[static_cast<std::size_t>(axis)]),
                 NC_("core", "give its column a minus sign, as --columns time=1,x=2:-mm")));
    }
  }
  if (found->backwards) {
    remarks.push_back(
        remark("trace-backwards",
               NC_("core", "the trace runs along the path of this program from its end to its start"),
               NC_("core",
                   "simulate the program that was recorded, with its blocks in the order that the control "
                   "ran them in")));
  }
  return remarks;
}

bool says_likeness(const Diagnostic& remark) {
  return remark.code == "trace-columns" || remark.code == "trace-backwards";
}

}  // namespace feedscope
