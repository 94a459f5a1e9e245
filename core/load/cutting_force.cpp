#include "core/load/cutting_force.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr double straight = 1e-6;          // [rad]; below it, the lag of a helix affects no displayed digit
constexpr double step = units::pi / 1440;  // of the rotation [rad]; a smooth peak is accurate to 1e-6
constexpr double beside = 1e-9;            // [rad]; to either side of the entry or exit of a tooth

/// Values of f_z^q between which the rotation of the peak hardly changes [mm^q].
constexpr double least_power = 1e-5;
constexpr double largest_power = 10;
constexpr int powers = 96;

}  // namespace

CuttingForce::CuttingForce(const Engagement& operation, const Material& material)
    : law_(force_law(material)),
      integrals_(law_.exponent),
      immersion_(immersion(operation)),
      pitch_(2 * units::pi / operation.teeth),
      depth_(operation.axial_depth),
      lag_(2 * std::tan(operation.helix) / operation.diameter * operation.axial_depth) {
  const double span = immersion_.to - immersion_.from;
  const double share = depth_ * operation.teeth / (2 * units::pi);
  const Parts whole = integral(immersion_.from, immersion_.to);
  mean_ = {share * whole.chip, share * whole.edge};
  const double arm = operation.diameter / 2 * share;
  chip_torque_ =
      arm * law_.chip[0] * (integrals_.of_power(immersion_.to) - integrals_.of_power(immersion_.from));
  edge_torque_ = arm * law_.edge[0] * span;
  const bool past_the_front = immersion_.from <= units::pi / 2 && immersion_.to >= units::pi / 2;
  largest_sine_ = past_the_front ? 1 : std::max(std::sin(immersion_.from), std::sin(immersion_.to));
  mean_sine_ = (std::cos(immersion_.from) - std::cos(immersion_.to)) / span;
  find_peaks();
}

/// Force of a tooth at `angle`, per width of cut.
CuttingForce::Parts CuttingForce::density(double angle) const {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const auto turned = [&](const std::array<double, 3>& k) {
    return Vec3(-k[0] * cosine - k[1] * sine, k[0] * sine - k[1] * cosine, k[2]);
  };
  return {integrals_.power(angle) * turned(law_.chip), turned(law_.edge)};
}

/// Integral of density() over the angle.
CuttingForce::Parts CuttingForce::integral(double from, double to) const {
  const auto turned = [](const std::array<double, 3>& k, double one, double sine, double cosine) {
    return Vec3(-k[0] * cosine - k[1] * sine, k[0] * sine - k[1] * cosine, k[2] * one);
  };
  return {turned(law_.chip, integrals_.of_power(to) - integrals_.of_power(from),
                 integrals_.of_power_times_sine(to) - integrals_.of_power_times_sine(from),
                 integrals_.of_power_times_cosine(to) - integrals_.of_power_times_cosine(from)),
          turned(law_.edge, to - from, std::cos(from) - std::cos(to), std::sin(to) - std::sin(from))};
}

/// The edge of a tooth whose tip is at `lead` covers the angles from lead - lag to lead.
CuttingForce::Parts CuttingForce::parts_at(double rotation) const {
  Parts sum;
  const double first = std::ceil((immersion_.from - rotation) / pitch_);
  for (double n = first; rotation + n * pitch_ - lag_ <= immersion_.to; ++n) {
    const double lead = rotation + n * pitch_;
    Parts tooth;
    double width = depth_;
    if (lag_ < straight) {
      tooth = density(lead);
    } else {
      const double from = std::max(immersion_.from, lead - lag_);
      const double to = std::min(immersion_.to, lead);
      tooth = integral(from, std::max(from, to));
      width = depth_ / lag_;
    }
    sum.chip += width * tooth.chip;
    sum.edge += width * tooth.edge;
  }
  return sum;
}

double CuttingForce::power_of(double feed_per_tooth) const {
  return law_.exponent == 1 ? feed_per_tooth : std::pow(feed_per_tooth, law_.exponent);
}

Vec3 CuttingForce::force_at(double feed_per_tooth, double rotation) const {
  const Parts parts = parts_at(rotation);
  return power_of(feed_per_tooth) * parts.chip + parts.edge;
}

/// Samples rotations over one pitch and on both sides of the entry or exit of a tooth, and keeps those with
/// the largest force at any of many feeds.
void CuttingForce::find_peaks() {
  std::vector<double> rotations;
  const int count = static_cast<int>(std::ceil(pitch_ / step));
  for (int i = 0; i < count; ++i) {
    rotations.push_back(pitch_ * i / count);
  }
  for (const double border : {immersion_.from, immersion_.to}) {
    for (const double lag : {0.0, lag_}) {
      rotations.push_back(border + lag - beside);
      rotations.push_back(border + lag + beside);
    }
  }
  std::vector<Square> squares;
  squares.reserve(rotations.size());
  for (const double rotation : rotations) {
    const Parts parts = parts_at(rotation);
    const auto chip = parts.chip.head<2>();
    const auto edge = parts.edge.head<2>();
    squares.push_back({chip.squaredNorm(), 2 * chip.dot(edge), edge.squaredNorm()});
  }
  std::set<std::size_t> kept;
  for (int i = 0; i < powers; ++i) {
    const double g =
        i == 0 ? 0
               : least_power * std::pow(largest_power / least_power, static_cast<double>(i) / (powers - 1));
    const auto largest = std::max_element(
        squares.begin(), squares.end(), [&](const Square& a, const Square& b) { return a.at(g) < b.at(g); });
    kept.insert(static_cast<std::size_t>(largest - squares.begin()));
  }
  for (const std::size_t i : kept) {
    peaks_.push_back(squares[i]);
  }
}

CuttingForce::Figures CuttingForce::at(double feed_per_tooth) const {
  const double g = power_of(feed_per_tooth);
  double square = 0;
  for (const Square& peak : peaks_) {
    square = std::max(square, peak.at(g));
  }
  return {g * mean_.chip + mean_.edge, std::sqrt(square), g * chip_torque_ + edge_torque_};
}

}  // namespace feedscope
