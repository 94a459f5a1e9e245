#include "ui/scene/draw/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <sstream>

#include "core/base/ticks.h"
#include "ui/scene/cause_colour.h"
#include "ui/scene/draw/colour_panel.h"
#include "ui/scene/draw/tool_axes.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

constexpr double row_height = 22;
constexpr double sample_width = 30;
constexpr double above_cube = 160;
constexpr double above_scale_bar = 48;

TextStyle text_style(double scale, const SceneColours& colours) {
  return {.size = panel_text_pixels * scale, .colour = colours.text, .horizontal = -1};
}

struct Entry {
  std::string text;
  std::function<void(Canvas&, const Vec2& from, const Vec2& to, double scale)> sample;
  bool continues = false;  ///< the text of the one above
  bool warns = false;
};

/// A short line in the colours of the path.
void draw_path_sample(Canvas& canvas, const Captions& captions, const Vec2& from, const Vec2& to,
                      double width) {
  if (!captions.key.has_scale()) {
    canvas.line(from, to, width,
                captions.key.colouring == Colouring::run ? captions.run : captions.colours->text);
    const std::vector<CauseShare>& causes = captions.key.causes;
    const double cut =
        std::accumulate(causes.begin(), causes.end(), 0.0, [](double sum, const CauseShare& cause) {
          return sum +
                 (cause.kind == CauseKind::rapid ? 0 : cause.share);  // rapids have a sample of their own
        });
    double done = 0;
    for (const CauseShare& cause : causes) {
      if (cause.kind != CauseKind::rapid) {
        const double end = done + cause.share / cut;
        canvas.line(from + done * (to - from), from + end * (to - from), width,
                    cause_colour(cause.kind, captions.colours->kind));
        done = end;
      }
    }
    return;
  }
  constexpr int parts = 16;
  for (int i = 0; i < parts; ++i) {
    canvas.line(from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts, width,
                scale_colour(captions.key.scale, (i + 0.5) / parts, captions.colours->kind));
  }
}

std::string exaggeration_text(const Captions& captions) {
  std::string text = captions.texts->exaggerated;
  if (const std::size_t place = text.find("%1"); place != std::string::npos) {
    text.replace(place, 2, captions.texts->localised(fmt::format("{:.6g}", captions.exaggeration)));
  }
  return text;
}

/// The words of `line` in rows no wider than `width`, a longer word in a row of its own.
std::vector<std::string> rows_of(const std::string& line, double width, const TextStyle& style) {
  std::vector<std::string> rows;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const std::string longer = rows.empty() ? word : rows.back() + " " + word;
    if (rows.empty() || Canvas::text_size(longer, style).x() > width) {
      rows.push_back(word);
    } else {
      rows.back() = longer;
    }
  }
  return rows;
}

/// `room`: width of the legend, `k`: scale of all sizes [pixels].
std::vector<Entry> legend(const Captions& captions, double room, double k) {
  const LegendEntries& entries = captions.entries;
  const SceneColours& colours = *captions.colours;
  const SceneTexts& texts = *captions.texts;
  std::vector<Entry> list;
  const auto solid = [](double width, Rgb colour) {
    return [width, colour](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
      canvas.line(from, to, width * scale, colour);
    };
  };
  // Not a line: how wide lines can be depends on the graphics.
  const auto bar = [](double width, Rgb colour) {
    return [width, colour](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
      const Vec2 half(0, width / 2 * scale);
      canvas.rectangle(from - half, to + half, colour);
    };
  };
  if (entries.programmed) {
    list.push_back({texts.programmed, solid(1.4, colours.programmed)});
  }
  if (entries.rapid) {
    list.push_back({texts.rapid, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.dashes(from, to, 1.6 * scale, 5 * scale, colours.rapid);
                    }});
  }
  if (entries.executed) {
    list.push_back({texts.executed, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      draw_path_sample(canvas, captions, from, to, 2.6 * scale);
                    }});
  }
  if (entries.curve) {
    list.push_back({texts.curve, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.line(from, to, 6 * scale, colours.curve_edge);
                      draw_path_sample(canvas, captions, from, to, 2.6 * scale);
                    }});
  }
  if (entries.blend) {
    list.push_back({texts.blend, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.line(from, to, 7 * scale, colours.blend_edge);
                      draw_path_sample(canvas, captions, from, to, 4.4 * scale);
                    }});
  }
  if (entries.tool_axis) {
    list.push_back({texts.tool_axis, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      draw_tool_axis(canvas, from, to, scale, colours);
                    }});
  }
  for (const auto& overlay : entries.overlays) {
    list.push_back({overlay.name, solid(1.8, overlay.colour)});
  }
  if (captions.on_machine) {
    list.push_back({texts.on_machine, solid(0, colours.text)});
  } else if (captions.exaggeration != 1) {
    list.push_back({exaggeration_text(captions), solid(0, colours.text)});
  }
  if (!texts.warning.empty()) {
    constexpr Rgb alarm{0.86, 0.15, 0.10};
    const double longest =
        room - (panel_margin + sample_width + 30) * k - Canvas::text_size(" …", text_style(k, colours)).x();
    std::istringstream lines(texts.warning);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t first = list.size();
      for (const std::string& row : rows_of(line, longest, text_style(k, colours))) {
        list.push_back({row, bar(list.size() == first ? 8 : 0, alarm), list.size() > first, true});
      }
    }
  }
  return list;
}

/// Calls `place(entry, lower left of its cell)` row by row; returns the rows used.
template <class Place>
int for_each_cell(const std::vector<Entry>& entries, double width, double scale, const SceneColours& colours,
                  Place place) {
  double x = panel_margin * scale;
  int row = entries.empty() ? 0 : 1;
  for (const Entry& entry : entries) {
    const double cell =
        Canvas::text_size(entry.text, text_style(scale, colours)).x() + (sample_width + 30) * scale;
    if ((x + cell > width || entry.continues) && x > panel_margin * scale) {
      x = panel_margin * scale;
      ++row;
    }
    place(entry, x, row);
    x += cell;
  }
  return row;
}

/// Every text that takes several rows with the first of them alone.
void shorten(std::vector<Entry>& list) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (list[i].continues && !list[i - 1].continues) {
      list[i - 1].text += " …";
    }
  }
  std::erase_if(list, [](const Entry& entry) { return entry.continues; });
}

/// Of those the ones that leave the path most of a picture that is `height` high: texts of several rows are
/// cut first, then warnings are kept before others.
std::vector<Entry> fitting_legend(const Captions& captions, double room, double height, double k) {
  constexpr double low = 400;
  const double most = height < low * k ? 0.25 : 0.45;
  std::vector<Entry> list = legend(captions, room, k);
  const auto is_too_high = [&] {
    return for_each_cell(list, room, k, *captions.colours, [](const Entry&, double, int) {}) * row_height *
               k >
           most * height;
  };
  if (is_too_high()) {
    shorten(list);
  }
  while (list.size() > 1 && is_too_high()) {
    const auto other =
        std::find_if(list.rbegin(), list.rend(), [](const Entry& entry) { return !entry.warns; });
    if (other != list.rend()) {
      list.erase(other.base() - 1);
      continue;
    }
    list.pop_back();
  }
  return list;
}

void draw_legend(Canvas& canvas, const ScreenLayout& layout, const Captions& captions) {
  const double k = layout.scale;
  const double width = layout.width - layout.panel_width;
  const SceneColours& colours = *captions.colours;
  if (!captions.transparent) {
    canvas.rectangle({0, layout.height - layout.legend_height}, {width, layout.height}, colours.background);
  }
  for_each_cell(fitting_legend(captions, width, layout.height, k), width, k, colours,
                [&](const Entry& entry, double x, int row) {
                  const double y = layout.height - (row - 0.5) * row_height * k - 4 * k;
                  entry.sample(canvas, {x, y}, {x + sample_width * k, y}, k);
                  canvas.text(entry.text, {x + (sample_width + 7) * k, y}, text_style(k, colours));
                });
}

void draw_scale_bar(Canvas& canvas, const Vec2& low, double width, double millimetre, double scale,
                    const Captions& captions) {
  const ShownUnit& unit = shown(Dimension::length);
  const double longest = width / millimetre * unit.factor;
  double length = round_up_125(longest);
  if (length > longest * (1 + 1e-9)) {
    length = round_up_125(longest / 2.5);
  }
  const SceneColours& colours = *captions.colours;
  const double pixels = length / unit.factor * millimetre;
  const Vec2 left = low;
  const Vec2 right = low + Vec2(pixels, 0);
  const Vec2 tick(0, 4 * scale);
  canvas.line(left, right, 2 * scale, colours.text);
  canvas.line(left - tick, left + tick, 2 * scale, colours.text);
  canvas.line(right - tick, right + tick, 2 * scale, colours.text);
  TextStyle style = text_style(scale, colours);
  style.vertical = -1;
  canvas.text(captions.texts->localised(fmt::format("{:.15g} {}", length, unit.text)),
              left + Vec2(0, 7 * scale), style);
}

}  // namespace

ScreenLayout screen_layout(int width, int height, double scale, const Captions& captions) {
  ScreenLayout layout{double(width), double(height), scale, 0, 0};
  layout.panel_width = colour_panel_width(captions, width, scale);
  const double room = width - layout.panel_width;
  const int rows = for_each_cell(fitting_legend(captions, room, height, scale), room, scale,
                                 *captions.colours, [](const Entry&, double, int) {});
  layout.cube = height - above_cube * scale >= min_colour_panel_height(captions, scale);
  layout.legend_height = rows * row_height * scale + (rows > 0 ? 8 * scale : 0);
  return layout;
}

void draw_captions(Canvas& canvas, const ScreenLayout& layout, const Captions& captions,
                   const Projection& projection, double millimetre) {
  const double k = layout.scale;
  const double left = layout.width - layout.panel_width;
  if (!captions.transparent) {
    canvas.rectangle({left, 0}, {layout.width, layout.height}, captions.colours->background);
  }
  draw_legend(canvas, layout, captions);
  if (!projection.perspective()) {
    draw_scale_bar(canvas, {left + panel_margin * k, 20 * k}, layout.panel_width - 2 * panel_margin * k,
                   millimetre, k, captions);
  }
  draw_colour_panel(canvas, captions, {left, (layout.cube ? above_cube : above_scale_bar) * k},
                    {layout.width, layout.height}, k);
}

}  // namespace feedscope::ui
