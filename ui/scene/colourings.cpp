#include "ui/scene/colourings.h"

#include <algorithm>
#include <array>

namespace feedscope::ui {
namespace {

constexpr Colouring colouring_of(QuantityId id) {
  return static_cast<Colouring>(id);
}

std::vector<Colouring> list_colourings() {
  std::vector<Colouring> list;
  for (const Dimension dimension : {Dimension::feed, Dimension::ratio, Dimension::acceleration,
                                    Dimension::jerk, Dimension::error, Dimension::force}) {
    for (const QuantityInfo& quantity : all_quantities()) {
      if (quantity.colours && quantity.dimension == dimension) {
        list.push_back(colouring_of(quantity.id));
      }
    }
  }
  for (auto i = static_cast<std::size_t>(Colouring::contour_error); i < colouring_count; ++i) {
    list.push_back(static_cast<Colouring>(i));
  }
  return list;
}

/// Indexed by Colouring.
std::array<std::size_t, colouring_count> list_samples() {
  std::array<std::size_t, colouring_count> samples{};
  std::size_t next = 0;
  for (const QuantityInfo& quantity : all_quantities()) {
    if (quantity.colours) {
      samples[static_cast<std::size_t>(quantity.id)] = next++;
    }
  }
  for (const Colouring other : {Colouring::time_lost, Colouring::path_distance}) {
    samples[static_cast<std::size_t>(other)] = next++;
  }
  return samples;
}

}  // namespace

const std::vector<Colouring>& all_colourings() {
  static const std::vector<Colouring> list = list_colourings();
  return list;
}

const QuantityInfo* quantity_of(Colouring colouring) {
  return colouring < Colouring::contour_error ? &info_of(static_cast<QuantityId>(colouring)) : nullptr;
}

std::string colouring_key(Colouring colouring) {
  if (const QuantityInfo* quantity = quantity_of(colouring)) {
    return std::string(quantity->key);
  }
  constexpr std::array others{"contour_error", "time_lost", "path_distance", "cause", "run"};
  return others.at(static_cast<std::size_t>(colouring) - static_cast<std::size_t>(Colouring::contour_error));
}

QuantitySource source_of(Colouring colouring) {
  const QuantityInfo* quantity = quantity_of(colouring);
  return quantity != nullptr ? quantity->source : QuantitySource::motion;
}

QuantitySource source_of_sample(std::size_t sample) {
  const auto colouring = std::ranges::find_if(all_colourings(), [sample](Colouring each) {
    return quantity_of(each) != nullptr && sample_index(each) == sample;
  });
  return colouring != all_colourings().end() ? source_of(*colouring) : QuantitySource::motion;
}

std::size_t sample_index(Colouring colouring) {
  static const std::array<std::size_t, colouring_count> samples = list_samples();
  return samples[static_cast<std::size_t>(colouring)];
}

}  // namespace feedscope::ui
