#include "core/program/sinumerik/geometry/kept_modes.h"

namespace feedscope::sinumerik {

KeptModes::Kept KeptModes::keep() const {
  return {.modal = modal_,
          .surface_speed = parts_.feeds.has_surface_speed(),
          .targets = parts_.targets.modes(),
          .path_words = parts_.path_modes.words(),
          .compensation = parts_.compensation.modes(),
          .corners = parts_.corners.modes(),
          .coordinates = parts_.coordinates.modes(),
          .axis_feeds = parts_.positioning_axes.feeds()};
}

void KeptModes::restore(const Kept& kept) {
  modal_ = kept.modal;
  parts_.feeds.restore_surface_speed(kept.surface_speed);
  parts_.targets.restore(kept.targets);
  parts_.path_modes.restore(kept.path_words);
  parts_.compensation.restore(kept.compensation);
  parts_.corners.restore(kept.corners);
  parts_.positioning_axes.restore(kept.axis_feeds);
  parts_.coordinates.restore(kept.coordinates);
}

}  // namespace feedscope::sinumerik
