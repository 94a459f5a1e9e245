#include "ui/scene/path/colouring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/ticks.h"
#include "core/base/units.h"
#include "ui/scene/cause_colour.h"
#include "ui/units/unit_system.h"

namespace feedscope::ui {
namespace {

/// Conditions under which a value is rare enough for the scale to omit it.
enum class Weight { points, time, length };
struct Rare {
  Weight weight = Weight::points;
  double share = 0.005;
  double far = 1.6;  ///< ratio to usual values from which on a scale omits the rest
};

/// Unit and kind of the scale of a colouring.
struct Scaled {
  ShownUnit unit;
  bool diverging = false;
};

Scaled scaled(Colouring colouring) {
  if (const QuantityInfo* quantity = quantity_of(colouring)) {
    return {shown(quantity->dimension), quantity->is_signed};
  }
  return colouring == Colouring::time_lost ? Scaled{shown(Dimension::pace), true}
                                           : Scaled{shown(Dimension::error), false};
}

/// Calls `use` with the value at each point in units of the samples, for colourings with a scale.
template <class Use>
void for_each_value(const SampledPath& path, Colouring colouring, Use use) {
  const auto& values = path.values_of(colouring);
  for (std::size_t i = 0; i < values.size(); ++i) {
    use(i, static_cast<double>(static_cast<float>(values[i])));
  }
}

/// Largest absolute values outside of rapids.
struct Peaks {
  double all = 0;
  double usual = 0;  ///< without the rare share
};

/// Weight of the span before a point.
double weight_of(const SampledPath& path, std::size_t i, Weight weight) {
  if (weight == Weight::points || i == 0) {
    return weight == Weight::points ? 1 : 0;
  }
  if (path.kinds[i - 1] == SpanKind::gap) {
    return 0;
  }
  return weight == Weight::time ? path.times[i] - path.times[i - 1]
                                : static_cast<double>((path.positions[i] - path.positions[i - 1]).norm());
}

/// The path's own time over its length without rapids [s/mm]; 0 if it has none.
double mean_pace(const SampledPath& path) {
  double time = 0;
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path.kinds[i - 1] != SpanKind::rapid) {
      const double span = weight_of(path, i, Weight::length);
      time += span > 0 ? path.times[i] - path.times[i - 1] : 0;
      length += span;
    }
  }
  return length > 0 ? time / length : 0;
}

/// Ignores values below `nothing`, unless all are.
Peaks peaks_of(const SampledPath& path, Colouring colouring, const Rare& rare, double nothing) {
  // The bits of positive values are in their order: 32768 of them form a histogram.
  std::vector<double> histogram(1U << 15U);
  Peaks peaks;
  for_each_value(path, colouring, [&](std::size_t i, double value) {
    if (path.kinds[i] != SpanKind::rapid && !std::isnan(value)) {
      const double size = std::abs(value);
      peaks.all = std::max(peaks.all, size);
      histogram[Stored(static_cast<float>(size)).value] += weight_of(path, i, rare.weight);
    }
  });
  const auto least = histogram.begin() + Stored(static_cast<float>(nothing)).value;
  if (std::any_of(least, histogram.end(), [](double weight) { return weight > 0; })) {
    std::fill(histogram.begin(), least, 0.0);
  }
  const double wanted = (1 - rare.share) * std::accumulate(histogram.begin(), histogram.end(), 0.0);
  double seen = 0;
  for (std::size_t bits = 0; bits < histogram.size() && seen < wanted; ++bits) {
    seen += histogram[bits];
    Stored edge;
    edge.value = static_cast<std::uint16_t>(bits);
    peaks.usual = seen > 0 ? static_cast<double>(static_cast<float>(edge)) : 0;
  }
  return peaks;
}

/// The next half step of a scale that contains `peak`, so that it ends at a round value.
double round_end(double peak) {
  const double half = round_ticks(0, peak, 10).step / 2;
  return half > 0 ? std::ceil(peak / half - 1e-2) * half : 0;
}

Rare rare_of(Colouring colouring) {
  switch (colouring) {
    case Colouring::feed:
      return {Weight::time, 0.05, 2.5};
    case Colouring::time_lost:
      return {Weight::length, 0.05};
    default:
      return {};
  }
}

ColourScale scale_of(const SampledPath& path, Colouring colouring) {
  const Scaled kind = scaled(colouring);
  ColourScale scale{std::string(kind.unit.text),          0, 0, kind.unit.factor, false, kind.diverging,
                    colouring == Colouring::path_distance};
  if (colouring == Colouring::feed_ratio) {
    scale.high = 100;
    return scale;
  }
  if (path.values_of(colouring).empty()) {
    return scale;  // no other run to compare with
  }
  const Rare rare = rare_of(colouring);
  // Not a share of the largest loss: at a stop, where the path is very short, a loss is unbounded.
  constexpr double nothing_lost = 1e-3;  // of the path's own time
  const double nothing = colouring == Colouring::time_lost ? nothing_lost * mean_pace(path) : 0;
  Peaks peaks = peaks_of(path, colouring, rare, nothing);
  if (colouring == Colouring::feed) {
    peaks.all = path.peak_feed;  // exact, not as stored
  }
  scale.beyond = peaks.usual > 0 && peaks.all > rare.far * peaks.usual;
  scale.high = round_end((scale.beyond ? peaks.usual : peaks.all) * scale.factor);
  constexpr double rounding = 1e-3;  // no contour error [um], no time lost [ms/mm]
  const bool length = colouring == Colouring::contour_error || colouring == Colouring::path_distance;
  if ((length || colouring == Colouring::time_lost) && scale.high < rounding) {
    scale.high = 1;
  }
  constexpr double micrometres = 1000;  // and thou in an inch
  if (length && scale.high > micrometres) {
    scale.unit = shown(Dimension::length).text;
    scale.factor /= micrometres;
    scale.high /= micrometres;
  }
  scale.low = scale.diverging ? -scale.high : 0;
  return scale;
}

std::vector<CauseShare> shares_of(const SampledPath& path) {
  constexpr double least_named = 0.0005;  // smaller shares would read 0.0 %
  const std::array<double, cause_kind_count>& time = path.cause_times;
  const double all = std::accumulate(time.begin(), time.end(), 0.0);
  std::vector<CauseShare> shares;
  for (std::size_t kind = 0; kind < time.size(); ++kind) {
    if (time[kind] > least_named * all) {
      shares.push_back({static_cast<CauseKind>(kind), time[kind] / all});
    }
  }
  std::ranges::stable_sort(shares, std::ranges::greater(), &CauseShare::share);
  return shares;
}

Rgba to_bytes(const Rgb& colour) {
  const auto byte = [](double part) { return static_cast<unsigned char>(std::lround(255 * part)); };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2]), 255};
}

/// The few largest changes, without those that are a small part of the largest.
std::vector<CauseChange> changes_of(const SampledPath& path) {
  constexpr std::size_t most = 3;
  constexpr double least_share = 0.05;
  constexpr double none = 1e-3;  // [s]
  std::vector<CauseChange> changes;
  for (std::size_t i = 0; i < cause_kind_count; ++i) {
    changes.push_back({static_cast<CauseKind>(i), path.cause_times[i] - path.reference_cause_times[i]});
  }
  const auto size = [](const CauseChange& change) { return std::abs(change.time); };
  std::ranges::sort(changes, std::ranges::greater(), size);
  changes.resize(most);
  const double least = std::max(none, least_share * size(changes.front()));
  std::erase_if(changes, [&](const CauseChange& change) { return size(change) < least; });
  return changes;
}

}  // namespace

std::string colouring_title(Colouring colouring, const SceneTexts& texts) {
  if (const QuantityInfo* quantity = quantity_of(colouring)) {
    return texts.name_of(*quantity);
  }
  switch (colouring) {
    case Colouring::contour_error:
      return texts.contour_error;
    case Colouring::time_lost:
      return texts.time_lost;
    case Colouring::path_distance:
      return texts.path_distance;
    case Colouring::cause:
      return texts.cause;
    default:
      return texts.executed;
  }
}

ColourKey colour_key(const SampledPath& path, Colouring colouring) {
  ColourKey key{colouring, {}, {}, {}};
  if (!path.executed() || colouring == Colouring::run) {
    return key;
  }
  if (colouring == Colouring::cause) {
    key.causes = shares_of(path);
  } else {
    key.scale = scale_of(path, colouring);
  }
  if (colouring == Colouring::time_lost && path.compared()) {
    key.lost = path.lost.back();
    key.changes = changes_of(path);
  }
  return key;
}

ColourKey colour_key(const SampledPath& path, const SampledPath& other, Colouring colouring) {
  ColourKey key = colour_key(path, colouring);
  const ColourScale second = colour_key(other, colouring).scale;
  if (!key.has_scale() || !(second.high > second.low)) {
    return key;
  }
  const bool beyond = key.scale.beyond || second.beyond;
  if (second.high / second.factor > key.scale.high / key.scale.factor) {
    key.scale = second;
  }
  key.scale.beyond = beyond;
  return key;
}

Rgb scale_colour(const ColourScale& scale, double position, Background background) {
  return scale.diverging   ? diverging_colour(2 * position - 1, background)
         : scale.from_pale ? diverging_colour(position, background)
                           : map_colour(position, background);
}

std::vector<Rgba> point_colours(const SampledPath& path, const ColourKey& key, Background background,
                                const Rgb& run) {
  std::vector<Rgba> colours(path.size(), to_bytes(run));
  if (key.colouring == Colouring::cause) {
    for (std::size_t i = 0; i < path.causes.size(); ++i) {
      colours[i] = to_bytes(cause_colour(path.causes[i], background));
    }
  } else if (key.has_scale()) {
    std::array<Rgba, colour_map_size> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = to_bytes(scale_colour(key.scale, static_cast<double>(i) / (table.size() - 1), background));
    }
    constexpr double last = colour_map_size - 1;
    const Rgba unknown = to_bytes(scene_colours(background).programmed);
    for_each_value(path, key.colouring, [&](std::size_t i, double value) {
      if (std::isnan(value)) {
        colours[i] = unknown;
        return;
      }
      const double index = std::clamp(key.scale.position(value), 0.0, 1.0) * last;
      colours[i] = table[static_cast<std::size_t>(index + 0.5)];
    });
  }
  return colours;
}

}  // namespace feedscope::ui
