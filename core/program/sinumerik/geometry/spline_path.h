#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/program/path/parametric_curve.h"
#include "core/program/text/diagnostic_log.h"

namespace feedscope::sinumerik {

/// PO[X]=(end, a2, a3, ...): the coordinate over the block's parameter p, from 0 to PL, is
/// start + a1 p + a2 p^2 + ..., where a1 leads to the end.
struct PolynomialWord {
  double end = 0;
  std::array<double, 4> coefficients{};  ///< a2 to a5

  /// `start` [mm], `interval` is PL (> 0).
  double at(double parameter, double start, double interval) const;
  double slope_at(double parameter, double start, double interval) const;

 private:
  double higher(double p) const;
  double first(double start, double interval) const;  ///< a1
};

/// End condition of a spline at its first or last point.
enum class SplineEnd {
  automatic,  ///< BAUTO, EAUTO: by its next points
  natural,    ///< BNAT, ENAT: straight
  tangent,    ///< BTAN, ETAN: along the neighbouring motion
};

/// Points of an ASPLINE, BSPLINE or CSPLINE over many blocks, and the curve through them. ASPLINE (Akima) and
/// CSPLINE (cubic, continuous curvature) interpolate their points, with the length of the chords as
/// parameter; a BSPLINE approximates its inner points, by weights.
class SplinePath {
 public:
  struct Point {
    Vec3 at = Vec3::Zero();
    double weight = 1;               ///< PW
    std::optional<double> interval;  ///< PL; of the knot that the point adds
    double feed = 0;                 ///< in force at the point
    std::uint32_t line = 0;          ///< shown
    DiagnosticLog::Place place;
  };

  bool empty() const { return points_.size() < 2; }
  bool begun() const { return !points_.empty(); }
  std::string_view kind() const { return kind_; }
  /// `direction`: of the previous motion, for BTAN; zero for none.
  void begin(std::string_view kind, const Point& start, const Vec3& direction);
  void add(const Point& point) { points_.push_back(point); }
  const Point& last() const { return points_.back(); }
  void clear() { points_.clear(); }

  void set_degree(int degree) { degree_ = degree; }
  /// BAUTO to ETAN.
  void set_end(std::string_view name);

  /// Receives a part of the curve: its first and last parameter, and the point of its block.
  using TakeSpan = std::function<void(const ParametricCurve&, double, double, const Point&)>;

  /// Passes on the parts in order. `direction`: of the next motion, for ETAN; zero for none.
  void spans(const Vec3& direction, const TakeSpan& take) const;

 private:
  void b_spline(const TakeSpan& take) const;
  void hermite(const std::vector<Vec3>& slopes, const std::vector<double>& steps, const TakeSpan& take) const;
  std::vector<Vec3> akima_slopes(const std::vector<double>& steps, const Vec3& direction) const;
  std::vector<Vec3> cubic_slopes(const std::vector<double>& steps, const Vec3& direction) const;
  std::vector<Vec3> differences(const std::vector<double>& steps) const;

  std::string_view kind_;
  std::vector<Point> points_;
  Vec3 direction_ = Vec3::Zero();
  SplineEnd begin_ = SplineEnd::automatic;
  SplineEnd end_ = SplineEnd::automatic;
  int degree_ = 3;
};

}  // namespace feedscope::sinumerik
