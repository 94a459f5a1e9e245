#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/samples/nc_writer.h"
#include "tests/samples/samples.h"

namespace feedscope::samples {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr double height = 40;        // of the blade, along Z [mm]
constexpr double half_chord = 20;    // at its root [mm]
constexpr double half_width = 3;     // likewise [mm]
constexpr double taper = 0.25;       // shorter at the tip by
constexpr double twist = pi / 6;     // of the tip against the root
constexpr double tool_radius = 4;    // of the ball [mm]
constexpr double lean = 35.0 / 180;  // of the tool from Z to the blade's normal [pi]
constexpr double pitch = 2;          // of the spiral [mm]
constexpr double lowest = 6;         // where it ends [mm]
constexpr int points = 160;          // a turn

/// Of the section at height z, `t` once around.
Vector2d section(double z, double t) {
  const double size = 1 - taper * z / height;
  const double x = half_chord * std::cos(t);
  const double camber = 2 * (1 - std::cos(t) * std::cos(t));
  const double y = half_width * std::sin(t) * (1 + 0.3 * std::cos(t)) + camber;
  return Eigen::Rotation2Dd(twist * z / height) * (size * Vector2d(x, y));
}

/// Outwards, across the section.
Vector2d normal(double z, double t) {
  constexpr double h = 1e-6;
  const Vector2d along = section(z, t + h) - section(z, t - h);
  return Vector2d(along.y(), -along.x()).normalized();
}

struct ToolPlace {
  Vector3d tip;
  Vector3d direction;
};

/// The ball touches the blade; the tool leans away from it.
ToolPlace place(double z, double t) {
  const Vector2d n = normal(z, t);
  const Vector2d at = section(z, t) + tool_radius * n;
  const Vector3d direction(std::sin(lean * pi) * n.x(), std::sin(lean * pi) * n.y(), std::cos(lean * pi));
  return {Vector3d(at.x(), at.y(), z) - tool_radius * direction, direction};
}

std::string words(const ToolPlace& at) {
  return fmt::format("X{:.4f} Y{:.4f} Z{:.4f} A3={:.6f} B3={:.6f} C3={:.6f}", at.tip.x(), at.tip.y(),
                     at.tip.z(), at.direction.x(), at.direction.y(), at.direction.z());
}

}  // namespace

Sample blade() {
  NcWriter nc(4);
  nc.raw("; Blade of 40 mm, twisted by 30 degrees: one spiral around it, the tool 35 degrees from Z");
  nc.raw("; Shows: a rotary axis that must turn half round at the edges of the blade");
  nc.raw("; Machine five-axis-table-ac; points of the tip of a ball of 8 mm, tool vectors");
  nc.raw("N10 G17 G710 G90 G94 G54");
  nc.raw("N20 T=\"BALL D8\" M6");
  nc.raw("N30 S16000 M3");
  nc.raw("N40 TRAORI");
  nc.raw("N50 ORIWKS ORIAXES");
  const int count = static_cast<int>(std::lround((height - lowest) / pitch)) * points;
  const auto at = [&](int i) { return place(height - i * pitch / points, 2 * pi * i / points); };
  const ToolPlace first = at(0);
  const ToolPlace above{first.tip + 30 * first.direction, first.direction};
  nc.raw(fmt::format("N60 G0 {}", words(above)));
  nc.raw(fmt::format("N70 G1 {} F2000", words(first)));
  nc.raw("N80 G642 F3000");
  for (int i = 1; i <= count; ++i) {
    nc.raw(fmt::format("N{} {}", 80 + 10 * i, words(at(i))));
  }
  const ToolPlace last = at(count);
  nc.raw(fmt::format("N{} G0 {}", 90 + 10 * count, words({last.tip + 60 * last.direction, last.direction})));
  nc.raw(fmt::format("N{} TRAFOOF", 100 + 10 * count));
  nc.raw(fmt::format("N{} M30", 110 + 10 * count));
  return {"sinumerik_blade.mpf", nc.text()};
}

}  // namespace feedscope::samples
