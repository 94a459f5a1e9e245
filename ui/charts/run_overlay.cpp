#include "ui/charts/run_overlay.h"

#include "core/analysis/programmed_place.h"

namespace feedscope::ui {

double same_place(const BlendedPath& from, double s, const BlendedPath& to) {
  return from.empty() || to.empty() ? 0 : path_length_of(to, programmed_place(from, s));
}

}  // namespace feedscope::ui
