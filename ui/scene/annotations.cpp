#include "ui/scene/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "core/base/units.h"
#include "ui/scene/ticks.h"

namespace feedscope::ui {
namespace {

constexpr double text_pixels = 13;
constexpr double row_height = 22;
constexpr double margin = 12;
constexpr double sample_width = 30;

TextStyle text_style(double scale) {
  return {.size = text_pixels * scale, .horizontal = -1};
}

struct Entry {
  std::string text;
  std::function<void(Canvas&, const Vec2& from, const Vec2& to, double scale)> sample;
};

std::vector<Entry> legend(const LegendEntries& entries) {
  std::vector<Entry> list;
  const auto gradient = [](Canvas& canvas, const Vec2& from, const Vec2& to, double width) {
    constexpr int parts = 16;
    for (int i = 0; i < parts; ++i) {
      canvas.line(from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts, width,
                  map_colour((i + 0.5) / parts));
    }
  };
  if (entries.programmed) {
    list.push_back({"programmed", [](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.line(from, to, 1.4 * scale, palette::programmed);
                    }});
  }
  if (entries.rapid) {
    list.push_back({"rapid", [](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.dashes(from, to, 1.6 * scale, 5 * scale, palette::rapid);
                    }});
  }
  if (entries.executed) {
    list.push_back({"executed", [gradient](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      gradient(canvas, from, to, 2.6 * scale);
                    }});
  }
  if (entries.blend) {
    list.push_back(
        {"corner blend", [gradient](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
           canvas.line(from, to, 7 * scale, palette::blend_edge);
           gradient(canvas, from, to, 4.4 * scale);
         }});
  }
  return list;
}

/// Calls `place(entry, lower left of its cell)` row by row; returns the rows used.
template <class Place>
int for_each_cell(const std::vector<Entry>& entries, double width, double scale, Place place) {
  double x = margin * scale;
  int row = entries.empty() ? 0 : 1;
  for (const Entry& entry : entries) {
    const double cell = Canvas::text_size(entry.text, text_style(scale)).x() + (sample_width + 30) * scale;
    if (x + cell > width && x > margin * scale) {
      x = margin * scale;
      ++row;
    }
    place(entry, x, row);
    x += cell;
  }
  return row;
}

void draw_legend(Canvas& canvas, const ScreenLayout& layout, const LegendEntries& entries) {
  const double k = layout.scale;
  const double width = layout.width - layout.panel_width;
  canvas.rectangle({0, layout.height - layout.legend_height}, {width, layout.height}, palette::background);
  for_each_cell(legend(entries), width, k, [&](const Entry& entry, double x, int row) {
    const double y = layout.height - (row - 0.5) * row_height * k - 4 * k;
    entry.sample(canvas, {x, y}, {x + sample_width * k, y}, k);
    canvas.text(entry.text, {x + (sample_width + 7) * k, y}, text_style(k));
  });
}

void draw_colour_bar(Canvas& canvas, const ScreenLayout& layout, double low, double high, double top_feed) {
  const double k = layout.scale;
  const double left = layout.width - layout.panel_width + margin * k;
  const double right = left + 16 * k;
  TextStyle title = text_style(k);
  title.bold = true;
  title.vertical = -1;
  canvas.text("Feed (mm/min)", {left, high + 14 * k}, title);
  constexpr int bands = colour_map_size / 2;
  for (int i = 0; i < bands; ++i) {
    const double from = low + (high - low) * i / bands;
    const double to = low + (high - low) * (i + 1) / bands;
    canvas.rectangle({left, from}, {right, to}, map_colour((i + 0.5) / bands));
  }
  const double top = units::to_mm_min(top_feed);
  const int most = std::max(2, static_cast<int>((high - low) / (34 * k)));
  const Ticks ticks = round_ticks(0, top, most);
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = low + (high - low) * ticks.values[i] / top;
    canvas.line({right, y}, {right + 4 * k, y}, k, palette::frame);
    canvas.text(ticks.labels[i], {right + 8 * k, y}, text_style(k));
  }
}

void draw_axes_cross(Canvas& canvas, const Projection& projection, const Vec2& centre, double scale) {
  constexpr double arm = 26;
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return projection.towards[a] < projection.towards[b]; });
  for (const int axis : order) {
    const Vec2 direction(projection.right[axis], projection.up[axis]);
    const Rgb& colour = palette::axes[static_cast<std::size_t>(axis)];
    constexpr double end_on = 0.2;
    if (direction.norm() < end_on) {
      canvas.disc(centre, 4 * scale, colour);
      continue;
    }
    canvas.line(centre, centre + arm * scale * direction, 2.4 * scale, colour);
    TextStyle style{.size = text_pixels * scale, .colour = colour, .bold = true};
    canvas.text(std::string(1, axis_names[static_cast<std::size_t>(axis)]),
                centre + scale * (arm * direction + 10 * direction.normalized()), style);
  }
}

void draw_scale_bar(Canvas& canvas, const Vec2& low, double width, double millimetre, double scale) {
  const double longest = width / millimetre;  // [mm]
  double length = round_up_125(longest);
  if (length > longest * (1 + 1e-9)) {
    length = round_up_125(longest / 2.5);
  }
  const double pixels = length * millimetre;
  const Vec2 left = low;
  const Vec2 right = low + Vec2(pixels, 0);
  const Vec2 tick(0, 4 * scale);
  canvas.line(left, right, 2 * scale, palette::text);
  canvas.line(left - tick, left + tick, 2 * scale, palette::text);
  canvas.line(right - tick, right + tick, 2 * scale, palette::text);
  TextStyle style = text_style(scale);
  style.vertical = -1;
  canvas.text(fmt::format("{:.15g} mm", length), left + Vec2(0, 7 * scale), style);
}

}  // namespace

ScreenLayout screen_layout(int width, int height, double scale, const LegendEntries& entries,
                           bool colour_bar) {
  TextStyle title = text_style(scale);
  title.bold = true;
  ScreenLayout layout{double(width), double(height), scale, 0, 0};
  const double content =
      colour_bar ? Canvas::text_size("Feed (mm/min)", title).x() : Canvas::text_size("1000 mm", title).x();
  layout.panel_width = content + 2 * margin * scale;
  const int rows =
      for_each_cell(legend(entries), width - layout.panel_width, scale, [](const Entry&, double, int) {});
  layout.legend_height = rows * row_height * scale + (rows > 0 ? 8 * scale : 0);
  return layout;
}

void draw_annotations(Canvas& canvas, const ScreenLayout& layout, const LegendEntries& entries,
                      const Projection& projection, double millimetre, double top_feed) {
  const double k = layout.scale;
  const double left = layout.width - layout.panel_width;
  canvas.rectangle({left, 0}, {layout.width, layout.height}, palette::background);
  draw_legend(canvas, layout, entries);
  const double inner = left + margin * k;
  draw_scale_bar(canvas, {inner, 20 * k}, layout.panel_width - 2 * margin * k, millimetre, k);
  draw_axes_cross(canvas, projection, {(left + layout.width) / 2, 96 * k}, k);
  const double low = 156 * k;
  const double high = std::min(layout.height - 48 * k, low + 420 * k);
  if (top_feed > 0 && high - low > 60 * k) {
    draw_colour_bar(canvas, layout, low, high, top_feed);
  }
}

void draw_start_marker(Canvas& canvas, const Vec2& place, double scale) {
  canvas.disc(place, 6 * scale, palette::background);
  canvas.disc(place, 5 * scale, palette::text);
  canvas.disc(place, 2.6 * scale, palette::background);
}

}  // namespace feedscope::ui
