#pragma once

#include <cstdint>
#include <optional>

#include "core/program/heidenhain/geometry/motion.h"

namespace feedscope::heidenhain {

/// Approaches to contours and departures from them: APPR, DEP, G26, G27.
class Approaches : private Part {
 public:
  /// All outlive it.
  Approaches(Context& context, Feeds& feeds, Tools& tools, Targets& targets, MFunctions& m_functions,
             Motions& motions)
      : Part(context),
        feeds_(feeds),
        tools_(tools),
        targets_(targets),
        m_functions_(m_functions),
        motions_(motions) {}

  /// Throws ReadFault, like the others.
  void approach(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column);
  /// Makes the previous line lead onto the contour by an arc of this radius [mm], with its own feed.
  void soften(double radius, const MotionWords& words, std::uint32_t column);
  /// `curve_feed`: feed of the part next to the contour; none: that of the words.
  void depart(ApproachKind kind, bool polar, const MotionWords& words, std::uint32_t column,
              const std::optional<ContourFeed>& curve_feed = std::nullopt);

 private:
  ApproachShape shape_of(ApproachKind kind, const MotionWords& words, std::uint32_t column) const;
  void check_side(std::uint32_t column) const;

  Feeds& feeds_;
  Tools& tools_;
  Targets& targets_;
  MFunctions& m_functions_;
  Motions& motions_;
};

}  // namespace feedscope::heidenhain
