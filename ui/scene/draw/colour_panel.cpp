#include "ui/scene/draw/colour_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/base/ticks.h"
#include "ui/scene/cause_colour.h"

namespace feedscope::ui {
namespace {

constexpr double panel_line_height = 17;
constexpr double cause_text_pixels = 12;
constexpr double cause_line_height = 14.5;
constexpr double cause_gap = 6;
constexpr double swatch = 11;
constexpr double bar_width = 16;
constexpr double longest_bar = 420;
constexpr double min_bar = 36;
constexpr double narrowest = 84;  // of what stands in the panel
constexpr double widest_causes = 128;
constexpr double largest_share = 0.4;  // of the window's width

TextStyle title_style(double scale, const SceneColours& colours) {
  return {.size = panel_text_pixels * scale,
          .colour = colours.text,
          .bold = true,
          .horizontal = -1,
          .vertical = 1};
}

TextStyle cause_style(double scale, const SceneColours& colours) {
  return {.size = cause_text_pixels * scale, .colour = colours.text, .horizontal = -1, .vertical = 1};
}

/// Behind the last line where it fits into `width`, otherwise on a line of its own.
void add_word(std::vector<std::string>& lines, const std::string& word, double width,
              const TextStyle& style) {
  if (!lines.empty() && Canvas::text_size(lines.back() + " " + word, style).x() <= width) {
    lines.back() += " " + word;
  } else {
    lines.push_back(word);
  }
}

/// Lines of words no wider than `width` where words allow.
std::vector<std::string> wrapped(const std::string& text, double width, const TextStyle& style) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    add_word(lines, word, width, style);
  }
  return lines;
}

std::string title_of(const Captions& captions) {
  const ColourKey& key = captions.key;
  if (key.reference.empty()) {
    return colouring_title(key.colouring, *captions.texts);
  }
  std::string title = key.colouring == Colouring::time_lost ? captions.texts->time_lost_against
                                                            : captions.texts->path_distance_from;
  if (const std::size_t place = title.find("%1"); place != std::string::npos) {
    title.replace(place, 2, key.reference);
  }
  return title;
}

std::vector<std::string> title_lines(const Captions& captions, double scale) {
  const TextStyle style = title_style(scale, *captions.colours);
  const ColourKey& key = captions.key;
  const double width = 1.3 * narrowest * scale;
  std::vector<std::string> lines = wrapped(title_of(captions), width, style);
  if (key.has_scale()) {
    add_word(lines, "(" + key.scale.unit + ")", width, style);
  }
  return lines;
}

bool has_panel(const ColourKey& key) {
  return key.has_scale() || !key.causes.empty();
}

std::vector<CauseRow> cause_rows(const Captions& captions, double width, double scale) {
  const TextStyle style = cause_style(scale, *captions.colours);
  std::vector<CauseRow> rows;
  for (const CauseShare& cause : captions.key.causes) {
    const double percent = 100 * cause.share;
    const std::string share =
        captions.texts->localised(percent < 0.1 ? "< 0.1 %" : fmt::format("{:.1f} %", percent));
    const SceneColours& colours = *captions.colours;
    CauseRow row{wrapped(captions.texts->name_of(cause.kind), width, style),
                 cause.kind == CauseKind::rapid ? colours.rapid : cause_colour(cause.kind, colours.kind)};
    add_word(row.lines, share, width, style);  // whole: a sign of percent alone says nothing
    rows.push_back(std::move(row));
  }
  return rows;
}

double height_of(const CauseRow& row, double scale) {
  return (static_cast<double>(row.lines.size()) * cause_line_height + cause_gap) * scale;
}

double draw_title(Canvas& canvas, const Captions& captions, Vec2 place, double scale) {
  const TextStyle style = title_style(scale, *captions.colours);
  for (const std::string& line : title_lines(captions, scale)) {
    canvas.text(line, place, style);
    place.y() -= panel_line_height * scale;
  }
  return place.y();
}

/// Round values of a scale, at most `most` of them but two at least: one number alone says nothing of the
/// rest.
Ticks bar_ticks(const ColourScale& scale, int most) {
  Ticks ticks = round_ticks(scale.low, scale.high, most);
  if (ticks.values.size() < 2 && scale.high > scale.low) {
    ticks.step = step_of_two(scale.low, scale.high);
    ticks.values = multiples(ticks.step, scale.low, scale.high);
    ticks.labels.clear();
    for (const double value : ticks.values) {
      ticks.labels.push_back(fmt::format("{:.{}f}", value, step_decimals(ticks.step)));
    }
  }
  return ticks;
}

void draw_bar(Canvas& canvas, const Captions& captions, const Vec2& low, double high, double k) {
  const ColourScale& scale = captions.key.scale;
  const SceneColours& colours = *captions.colours;
  const double right = low.x() + bar_width * k;
  constexpr int bands = colour_map_size / 2;
  const double height = high - low.y();
  for (int i = 0; i < bands; ++i) {  // each behind the next one: viewers of PDF show the ground between edges
    canvas.rectangle({low.x(), low.y() + height * i / bands},
                     {right, low.y() + height * std::min(i + 2, bands) / bands},
                     scale_colour(scale, (i + 0.5) / bands, colours.kind));
  }
  const int most = std::max(2, static_cast<int>(height / (34 * k)));
  const Ticks ticks = bar_ticks(scale, most);
  TextStyle style{.size = panel_text_pixels * k, .colour = colours.text, .horizontal = -1};
  const bool has_words = captions.key.colouring == Colouring::time_lost;
  const double inside = (panel_text_pixels + 3) * k;
  const auto under_word = [&](double y) {
    const double least = panel_text_pixels * k;
    return has_words && (std::abs(y - (high - inside)) < least || std::abs(y - (low.y() + inside)) < least);
  };
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = low.y() + height * (ticks.values[i] - scale.low) / (scale.high - scale.low);
    canvas.line({right, y}, {right + 4 * k, y}, k, colours.frame);
    if (under_word(y)) {
      continue;
    }
    std::string label = captions.texts->localised(ticks.labels[i]);
    const bool at_end = scale.high - ticks.values[i] < ticks.step / 2;
    const bool at_start = ticks.values[i] - scale.low < ticks.step / 2;
    if (scale.beyond && at_end) {
      label = "≥ " + label;
    } else if (scale.beyond && scale.diverging && at_start) {
      label = "≤ " + label;
    }
    canvas.text(label, {right + 8 * k, y}, style);
  }
  if (scale.beyond && !ticks.values.empty() && scale.high - ticks.values.back() >= ticks.step / 2) {
    const auto end_label = [&](const char* sign, double value) {
      return captions.texts->localised(fmt::format("{} {:.6g}", sign, value));
    };
    canvas.text(end_label("≥", scale.high), {right + 8 * k, high}, style);
    if (scale.diverging) {
      canvas.text(end_label("≤", scale.low), {right + 8 * k, low.y()}, style);
    }
  }
  if (has_words) {
    canvas.text(captions.texts->lost, {right + 8 * k, high - inside}, style);
    canvas.text(captions.texts->won, {right + 8 * k, low.y() + inside}, style);
  }
}

void draw_causes(Canvas& canvas, const Captions& captions, Vec2 place, double lowest, double width,
                 double scale) {
  const TextStyle style = cause_style(scale, *captions.colours);
  for (const CauseRow& row : fitting_cause_rows(captions, width, place.y() - lowest, scale)) {
    const double height = height_of(row, scale);
    if (row.colour) {
      const Vec2 corner(place.x(), place.y() - (swatch + 2) * scale);
      canvas.rectangle(corner, corner + Vec2::Constant(swatch * scale), *row.colour);
    }
    for (std::size_t i = 0; i < row.lines.size(); ++i) {
      canvas.text(row.lines[i],
                  place + Vec2(1.6 * swatch, -static_cast<double>(i) * cause_line_height) * scale, style);
    }
    place.y() -= height;
  }
}

}  // namespace

std::vector<CauseRow> fitting_cause_rows(const Captions& captions, double width, double height,
                                         double scale) {
  std::vector<CauseRow> rows = cause_rows(captions, width - 1.6 * swatch * scale, scale);
  const double one_line = (cause_line_height + cause_gap) * scale;
  double used = 0;
  std::size_t fitting = 0;  // with room for a line below them
  for (const CauseRow& row : rows) {
    used += height_of(row, scale);
    fitting += used + one_line <= height ? 1 : 0;
  }
  if (used > height) {
    const std::size_t omitted = rows.size() - fitting;
    rows.resize(fitting);
    if ((fitting > 0 ? 0 : one_line) <= height) {
      rows.push_back({{fmt::format("+ {}", omitted)}, std::nullopt});
    }
  }
  return rows;
}

double colour_panel_width(const Captions& captions, int width, double scale) {
  double content = narrowest * scale;
  if (has_panel(captions.key)) {
    const TextStyle style = title_style(scale, *captions.colours);
    for (const std::string& line : title_lines(captions, scale)) {
      content = std::max(content, Canvas::text_size(line, style).x());
    }
  }
  if (!captions.key.causes.empty()) {
    content = std::max(content, widest_causes * scale);
  }
  return std::min(content + 2 * panel_margin * scale, largest_share * width);
}

double min_colour_panel_height(const Captions& captions, double scale) {
  const auto lines = static_cast<double>(title_lines(captions, scale).size());
  return has_panel(captions.key) ? (16 + lines * panel_line_height + min_bar) * scale : 0;
}

void draw_colour_panel(Canvas& canvas, const Captions& captions, const Vec2& low, const Vec2& high,
                       double scale) {
  if (!has_panel(captions.key)) {
    return;
  }
  const double left = low.x() + panel_margin * scale;
  const double width = high.x() - low.x() - 2 * panel_margin * scale;
  const double title = panel_line_height * scale * static_cast<double>(title_lines(captions, scale).size());
  const bool causes = !captions.key.causes.empty();
  const double room = high.y() - 16 * scale - title - low.y();
  if (room < min_bar * scale) {
    return;
  }
  // A scale stands above what is below the panel, causes hang from the top.
  const double content = causes ? room : std::min(room - 10 * scale, longest_bar * scale);
  const double top = causes ? high.y() - 16 * scale : low.y() + content + title + 14 * scale;
  const double below_title = draw_title(canvas, captions, {left, top}, scale);
  if (causes) {
    draw_causes(canvas, captions, {left, below_title - 4 * scale}, low.y(), width, scale);
  } else {
    draw_bar(canvas, captions, {left, low.y()}, low.y() + content, scale);
  }
}

}  // namespace feedscope::ui
