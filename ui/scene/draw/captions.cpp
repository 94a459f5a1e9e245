#include "ui/scene/draw/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/base/short_text.h"
#include "core/base/ticks.h"
#include "ui/scene/cause_colour.h"
#include "ui/scene/draw/tool_axes.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

// [pixels] at scale 1.
constexpr double caption_text = 12;
constexpr double caption_row = 18;
constexpr double caption_margin = 10;  // from the edges of the window
constexpr double caption_padding = 5;  // around the texts
constexpr double line_sample = 24;
constexpr double after_entry = 14;
constexpr double cause_swatch = 10;
constexpr double bar_length = 180;
constexpr double bar_height = 8;
constexpr double before_unit = 4;
constexpr double longest_scale_bar = 120;
constexpr double strip_height = 32;
constexpr double cube_side = 44;
constexpr double cube_letters = 12;    // around the cube
constexpr double behind_texts = 0.85;  // opacity

TextStyle caption_style(double scale, const SceneColours& colours) {
  return {.size = caption_text * scale, .colour = colours.text, .horizontal = -1};
}

double text_width(const std::string& text, double scale) {
  return Canvas::text_size(text, {.size = caption_text * scale}).x();
}

/// A text shortened to `width` at a word boundary.
std::string shortened(std::string text, double width, double scale) {
  if (text_width(text, scale) <= width) {
    return text;
  }
  while (!text.empty() && text_width(text + " …", scale) > width) {
    const std::size_t word = text.find_last_of(' ');
    text.resize(word == std::string::npos ? 0 : word);
  }
  return text + " …";
}

struct CaptionEntry {
  std::string text;
  std::function<void(Canvas&, const Vec2& from, const Vec2& to, double scale)> sample;  ///< null: none
};

double entry_width(const CaptionEntry& entry, double scale) {
  return text_width(entry.text, scale) + (entry.sample ? line_sample + 6 : 0) * scale;
}

CaptionEntry line_entry(const std::string& text, double width, const Rgb& colour) {
  return {text, [width, colour](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
            canvas.line(from, to, width * scale, colour);
          }};
}

/// The path in a neutral colour on the edge that marks a part of it.
CaptionEntry edged_entry(const std::string& text, double width, const Rgb& edge,
                         const SceneColours& colours) {
  return {text, [width, edge, &colours](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
            canvas.line(from, to, (width + 3) * scale, edge);
            canvas.line(from, to, width * scale, colours.programmed);
          }};
}

std::string with(std::string text, const std::string& part) {
  if (const std::size_t place = text.find("%1"); place != std::string::npos) {
    text.replace(place, 2, part);
  }
  return text;
}

std::string with_factor(const Captions& captions) {
  return with(captions.texts->exaggerated,
              captions.texts->localised(fmt::format("{:.6g}", captions.exaggeration)));
}

bool explains_colours(const ColourKey& key) {
  return key.has_scale() || !key.causes.empty();
}

std::vector<CaptionEntry> legend_entries(const Captions& captions) {
  const LegendEntries& entries = captions.entries;
  const SceneColours& colours = *captions.colours;
  const SceneTexts& texts = *captions.texts;
  std::vector<CaptionEntry> list;
  if (entries.executed && !explains_colours(captions.key)) {
    list.push_back(line_entry(texts.executed, 2.6,
                              captions.key.colouring == Colouring::run ? captions.run : colours.programmed));
  }
  for (const auto& overlay : entries.overlays) {
    list.push_back(
        line_entry(overlay.beneath ? with(texts.beneath, overlay.name) : overlay.name, 1.8, overlay.colour));
  }
  if (entries.programmed) {
    list.push_back(line_entry(texts.programmed, 1.4, colours.programmed));
  }
  if (entries.rapid && !std::ranges::count(captions.key.causes, CauseKind::rapid, &CauseShare::kind)) {
    list.push_back({texts.rapid, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      canvas.dashes(from, to, 1.4 * scale, 4 * scale, colours.rapid);
                    }});
  }
  if (entries.curve) {
    list.push_back(edged_entry(texts.curve, 2.6, colours.curve_edge, colours));
  }
  if (entries.blend) {
    list.push_back(edged_entry(texts.blend, 4, colours.blend_edge, colours));
  }
  if (entries.tool_axis) {
    list.push_back({texts.tool_axis, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      draw_tool_axis(canvas, from, to, scale, colours);
                    }});
  }
  if (entries.start) {
    list.push_back({texts.start, [&](Canvas& canvas, const Vec2& from, const Vec2& to, double scale) {
                      draw_start_mark(canvas, (from + to) / 2, scale, colours);
                    }});
  }
  if (captions.on_machine) {
    list.push_back({texts.on_machine, nullptr});
  } else if (captions.exaggeration != 1) {
    list.push_back({with_factor(captions), nullptr});
  }
  std::erase_if(list, [](const CaptionEntry& entry) { return entry.text.empty(); });
  return list;
}

std::vector<CaptionEntry> cause_entries(const Captions& captions) {
  const SceneColours& colours = *captions.colours;
  std::vector<CaptionEntry> list;
  for (const CauseShare& cause : captions.key.causes) {
    const std::string share = fmt::format("{:.1f} %", 100 * cause.share);
    const Rgb colour =
        cause.kind == CauseKind::rapid ? colours.rapid : cause_colour(cause.kind, colours.kind);
    list.push_back({captions.texts->name_of(cause.kind) + " " + captions.texts->localised(share),
                    [colour](Canvas& canvas, const Vec2&, const Vec2& to, double scale) {
                      const Vec2 half = Vec2::Constant(cause_swatch / 2 * scale);
                      const Vec2 middle = to - Vec2(half.x(), 0);
                      canvas.rectangle(middle - half, middle + half, colour);
                    }});
  }
  return list;
}

/// Entries in rows of at most `width` [pixels].
struct CaptionRows {
  struct Cell {
    CaptionEntry entry;
    double x = 0;  ///< from the left [pixels]
    int row = 0;   ///< from the top
  };
  std::vector<Cell> cells;
  int rows = 0;
  double width = 0;

  /// The first `most_rows` rows.
  static CaptionRows of(std::vector<CaptionEntry> entries, double width, int most_rows, double scale) {
    CaptionRows rows;
    double x = 0;
    for (CaptionEntry& entry : entries) {
      const double sample = entry_width(entry, scale) - text_width(entry.text, scale);
      entry.text = shortened(std::move(entry.text), width - sample, scale);
      const double cell = entry_width(entry, scale);
      const bool begins_row = rows.rows == 0 || x + cell > width;
      if (begins_row && rows.rows == std::max(1, most_rows)) {
        break;
      }
      rows.rows += begins_row ? 1 : 0;
      x = begins_row ? 0 : x;
      rows.cells.push_back({std::move(entry), x, rows.rows - 1});
      rows.width = std::max(rows.width, x + cell);
      x += cell + after_entry * scale;
    }
    return rows;
  }

  Vec2 size(double scale) const {
    return {width + 2 * caption_padding * scale, rows > 0 ? rows * caption_row * scale : 0};
  }

  void draw(Canvas& canvas, const ScreenRectangle& place, double scale, const SceneColours& colours) const {
    for (const Cell& cell : cells) {
      Vec2 at(place.low.x() + caption_padding * scale + cell.x,
              place.high.y() - (cell.row + 0.5) * caption_row * scale);
      if (cell.entry.sample) {
        cell.entry.sample(canvas, at, at + Vec2(line_sample * scale, 0), scale);
        at.x() += (line_sample + 6) * scale;
      }
      canvas.text(cell.entry.text, at, caption_style(scale, colours));
    }
  }
};

CaptionRows legend_rows(double width, double height, double scale, const Captions& captions) {
  if (!captions.legend) {
    return {};
  }
  const double right = captions.cube ? cube_side + 2 * cube_letters + caption_margin : caption_margin;
  constexpr double most_of_height = 0.25;
  return CaptionRows::of(legend_entries(captions),
                         width - (caption_margin + right + 2 * caption_padding) * scale,
                         static_cast<int>(most_of_height * height / (caption_row * scale)), scale);
}

CaptionRows cause_rows(double width, double height, double scale, const Captions& captions) {
  constexpr double most_of_height = 0.25;
  return CaptionRows::of(cause_entries(captions), width - 2 * (caption_margin + caption_padding) * scale,
                         static_cast<int>(most_of_height * height / (caption_row * scale)), scale);
}

/// The scale of colours with its texts.
struct ColourBar {
  std::string title;
  std::vector<std::string> changes;  ///< lines below it
  std::array<std::string, 3> ticks;
  std::string unit;
  bool has_words = false;  ///< "gained" and "lost" at its ends
  double after = 0;        ///< width of the unit after the bar [pixels]
  double length = 0;       ///< [pixels]

  ColourBar(double width, double scale, const Captions& captions)
      : title(shortened(with_total(captions), width - 2 * (caption_margin + caption_padding) * scale, scale)),
        unit(captions.key.scale.unit),
        has_words(captions.key.colouring == Colouring::time_lost),
        after(unit.empty() ? 0 : text_width(unit, scale) + before_unit * scale),
        length(std::min(bar_length * scale, width - 2 * (caption_margin + caption_padding) * scale - after)) {
    if (captions.strip) {  // the scale bar is in the same row
      const double others = text_width(title, scale) + after +
                            (5 * caption_margin + longest_scale_bar + 2 * caption_padding) * scale;
      length = std::min(length, std::max(least_length * scale, width - others));
    }
    for (const CauseChange& change : captions.key.changes) {
      changes.push_back(captions.texts->name_of(change.kind) + " " + signed_time(change.time, captions));
    }
    const ColourScale& of = captions.key.scale;
    const std::array values{of.low, (of.low + of.high) / 2, of.high};
    const std::array signs{of.beyond && of.diverging ? "≤ " : "", "", of.beyond ? "≥ " : ""};
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      constexpr double many_digits = 1e4;  // from here on 4 digits would need a power of ten
      const bool large = std::abs(values[i]) >= many_digits;
      ticks[i] = signs[i] + captions.texts->localised(large ? fmt::format("{:.0f}", values[i])
                                                            : fmt::format("{:.4g}", values[i]));
    }
  }

  Vec2 size(double scale) const {
    double content = std::max(text_width(title, scale), length + after);
    for (const std::string& change : changes) {
      content = std::max(content, text_width(change, scale));
    }
    const int rows = (has_words ? 3 : 2) + static_cast<int>(changes.size());
    return {content + 2 * caption_padding * scale, (bar_height + 6 + caption_row * rows) * scale};
  }

  void draw(Canvas& canvas, const ScreenRectangle& place, double scale, const Captions& captions) const {
    const TextStyle style = caption_style(scale, *captions.colours);
    const double left = place.low.x() + caption_padding * scale;
    canvas.text(title, {left, place.high.y() - caption_row / 2 * scale}, style);
    double top = place.high.y() - (caption_row + 2) * scale;
    for (const std::string& change : changes) {
      canvas.text(change, {left, top - (caption_row / 2 - 2) * scale}, style);
      top -= caption_row * scale;
    }
    draw_scale(canvas, {left, top}, scale, captions);
  }

  /// In one row with its title.
  void draw_in_strip(Canvas& canvas, const ScreenRectangle& place, double scale,
                     const Captions& captions) const {
    const Vec2 at = place.low + Vec2(caption_margin, strip_height - 5) * scale;
    canvas.text(title, at - Vec2(0, bar_height / 2 * scale), caption_style(scale, *captions.colours));
    draw_scale(canvas, at + Vec2(text_width(title, scale) + caption_margin * scale, 0), scale, captions);
  }

 private:
  /// The bar with its numbers below and its unit after them; `corner`: its upper left one.
  void draw_scale(Canvas& canvas, const Vec2& corner, double scale, const Captions& captions) const {
    TextStyle style = caption_style(scale, *captions.colours);
    const double left = corner.x();
    const double top = corner.y();
    draw_bar(canvas, {left, top - bar_height * scale}, top, captions);
    const double y = top - (bar_height + 2 + caption_row / 2) * scale;
    canvas.text(unit, {left + length + before_unit * scale, y}, style);
    for (int i = 0; i < 3; ++i) {
      style.horizontal = i - 1;
      const double x = left + length * i / 2;
      if (i != 1 || length > narrow_bar * scale) {
        canvas.text(ticks[static_cast<std::size_t>(i)], {x, y}, style);
      }
      if (has_words && i != 1) {
        canvas.text(i == 0 ? captions.texts->won : captions.texts->lost, {x, y - caption_row * scale}, style);
      }
    }
  }

  static std::string signed_time(double time, const Captions& captions) {
    return captions.texts->localised((time < 0 ? "-" : "+") + short_time(std::abs(time)));
  }

  static std::string with_total(const Captions& captions) {
    constexpr double none = 1e-3;  // [s]
    const std::string title = colour_title(captions.key, *captions.texts);
    return std::abs(captions.key.lost) < none ? title
                                              : title + ": " + signed_time(captions.key.lost, captions);
  }

  static constexpr double narrow_bar = 150;  // three numbers would not fit
  static constexpr double least_length = 60;

  void draw_bar(Canvas& canvas, const Vec2& low, double top, const Captions& captions) const {
    constexpr int bands = colour_map_size / 2;
    for (int i = 0; i < bands; ++i) {  // each overlaps the next: PDF viewers show gaps between edges
      canvas.rectangle({low.x() + length * i / bands, low.y()},
                       {low.x() + length * std::min(i + 2, bands) / bands, top},
                       scale_colour(captions.key.scale, (i + 0.5) / bands, captions.colours->kind));
    }
  }
};

ScreenRectangle colours_place(double width, double height, double scale, const Captions& captions) {
  if (!captions.legend || !explains_colours(captions.key)) {
    return {};
  }
  if (captions.strip && captions.key.has_scale()) {
    return {Vec2::Zero(), {width, strip_height * scale}};
  }
  const Vec2 size = captions.key.has_scale() ? ColourBar(width, scale, captions).size(scale)
                                             : cause_rows(width, height, scale, captions).size(scale);
  const Vec2 low = Vec2::Constant(caption_margin * scale);
  return {low, low + size};
}

/// In the centre, else to the right of the colours or above them; none in a small picture. At the right of a
/// strip of colours.
ScreenRectangle scale_bar_place(const ScreenLayout& layout) {
  const double k = layout.scale;
  const Vec2 size((longest_scale_bar + 2 * caption_padding) * k, (caption_row + 8) * k);
  const auto at = [&](double x, double y) { return ScreenRectangle{{x, y}, Vec2(x, y) + size}; };
  constexpr double enough_wide = 2;
  constexpr double enough_high = 6;
  if (layout.width < enough_wide * size.x() || layout.height < enough_high * size.y()) {
    return {};
  }
  const ScreenRectangle middle = at((layout.width - size.x()) / 2, caption_margin * k);
  const double right = layout.width - caption_margin * k - size.x();
  if (layout.colours.high.x() == layout.width) {
    return at(right, (strip_height - caption_row - 8) / 2 * k);
  }
  if (layout.colours.empty() || !middle.meets(layout.colours.grown(after_entry * k))) {
    return middle;
  }
  return right > layout.colours.high.x() + after_entry * k
             ? at(right, caption_margin * k)
             : at(middle.low.x(), layout.colours.high.y() + caption_padding * k);
}

void draw_scale_bar(Canvas& canvas, const ScreenRectangle& place, double millimetre, double scale,
                    const Captions& captions) {
  const ShownUnit& unit = shown(Dimension::length);
  const double longest = longest_scale_bar * scale / millimetre * unit.factor;
  double length = round_up_125(longest);
  if (length > longest * (1 + 1e-9)) {
    length = round_up_125(longest / 2.5);
  }
  const SceneColours& colours = *captions.colours;
  const Vec2 half(length / unit.factor * millimetre / 2, 0);
  const Vec2 middle(place.centre().x(), place.low.y() + 5 * scale);
  const Vec2 tick(0, 3 * scale);
  canvas.line(middle - half, middle + half, 1.5 * scale, colours.text);
  for (const Vec2& end : {Vec2(middle - half), Vec2(middle + half)}) {
    canvas.line(end - tick, end + tick, 1.5 * scale, colours.text);
  }
  TextStyle style = caption_style(scale, colours);
  style.horizontal = 0;
  style.vertical = -1;
  canvas.text(captions.texts->localised(fmt::format("{:.15g} {}", length, unit.text)),
              middle + Vec2(0, 5 * scale), style);
}

}  // namespace

ScreenRectangle ScreenLayout::room() const {
  constexpr double share = 0.02;  // of the shorter side, in a small picture
  return window().grown(-std::min(12 * scale, share * std::min(width, height)));
}

std::vector<ScreenRectangle> ScreenLayout::covered() const {
  std::vector<ScreenRectangle> all{legend, colours, scale_bar, cube};
  std::erase_if(all, [](const ScreenRectangle& rectangle) { return rectangle.empty(); });
  return all;
}

ScreenRectangle ScreenLayout::inset(double side, bool left) const {
  const double margin = caption_margin * scale;
  Vec2 low(left ? margin : width - margin - side, margin);
  const auto place = [&] { return ScreenRectangle{low, low + Vec2::Constant(side)}; };
  for (const ScreenRectangle& below : {colours, scale_bar}) {
    if (!below.empty() && place().meets(below)) {
      low.y() = below.high.y() + caption_padding * scale;
    }
  }
  return place();
}

ScreenLayout screen_layout(int width, int height, double scale, const Captions& captions) {
  ScreenLayout layout{double(width), double(height), scale, {}, {}, {}, {}};
  const double margin = caption_margin * scale;
  const Vec2 legend = legend_rows(width, height, scale, captions).size(scale);
  layout.legend =
      captions.strip && legend.y() > 0
          ? ScreenRectangle{{0, height - legend.y()}, {double(width), double(height)}}
          : ScreenRectangle{{margin, height - margin - legend.y()}, {margin + legend.x(), height - margin}};
  layout.colours = colours_place(width, height, scale, captions);
  layout.scale_bar = captions.legend ? scale_bar_place(layout) : ScreenRectangle{};
  const Vec2 corner(width - margin, height - margin);
  const double side = (cube_side + cube_letters) * scale;
  constexpr double least = 3;  // smallest window, in cubes
  if (captions.cube && std::min(width, height) > least * side) {
    layout.cube = {corner - Vec2::Constant(side), corner};
  }
  return layout;
}

std::string colour_title(const ColourKey& key, const SceneTexts& texts) {
  if (key.reference.empty()) {
    return colouring_title(key.colouring, texts);
  }
  return with(key.colouring == Colouring::time_lost ? texts.time_lost_against : texts.path_distance_from,
              key.reference);
}

std::size_t named_causes(int width, int height, double scale, const Captions& captions) {
  return cause_rows(width, height, scale, captions).cells.size();
}

void draw_captions(Canvas& canvas, const ScreenLayout& layout, const Captions& captions,
                   const Projection& projection, double millimetre) {
  const double k = layout.scale;
  const SceneColours& colours = *captions.colours;
  const bool has_bar = !layout.scale_bar.empty() && !projection.perspective();
  for (const ScreenRectangle& place :
       {layout.legend, layout.colours, has_bar ? layout.scale_bar : ScreenRectangle{}}) {
    if (!place.empty() && !captions.transparent) {
      canvas.rectangle(place.low, place.high, colours.background, captions.strip ? 1 : behind_texts);
    }
  }
  legend_rows(layout.width, layout.height, k, captions).draw(canvas, layout.legend, k, colours);
  if (has_bar) {
    draw_scale_bar(canvas, layout.scale_bar, millimetre, k, captions);
  }
  if (layout.colours.empty()) {
    return;
  }
  if (captions.strip && captions.key.has_scale()) {
    ColourBar(layout.width, k, captions).draw_in_strip(canvas, layout.colours, k, captions);
  } else if (captions.key.has_scale()) {
    ColourBar(layout.width, k, captions).draw(canvas, layout.colours, k, captions);
  } else {
    cause_rows(layout.width, layout.height, k, captions).draw(canvas, layout.colours, k, colours);
  }
}

}  // namespace feedscope::ui
