#pragma once

#include "core/analysis/contour/contour_report.h"

namespace feedscope {

/// Name in files.
inline const char* contour_word(ContourSpot::Kind kind) {
  switch (kind) {
    case ContourSpot::Kind::arc:
      return "arc";
    case ContourSpot::Kind::corner:
      return "corner";
    case ContourSpot::Kind::line:
      break;
  }
  return "line";
}

}  // namespace feedscope
