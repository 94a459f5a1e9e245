#pragma once

#include <memory>

#include "ui/report/pictures.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// The place of a card, with a lens if it is a corner of several runs.
struct PlaceShot {
  SlowPlace place;
  std::shared_ptr<const LensShot> lens;  ///< null: without a lens
};
/// Contents of card `number`, from 1. Throws InputError for a number without a card. `input` as of
/// with_time_report().
PlaceShot place_shot(const ReportInput& input, std::size_t number);

/// Name of the picture of a group's first card; "" without one.
QString card_picture_of(const TimeReport& report, const SlowGroup& group);

/// A card for each group of places where the current run loses time, the largest loss first: common
/// properties of its places, the worst one explained, and a picture of that. If there are few groups, further
/// places of them.
QString cards_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
