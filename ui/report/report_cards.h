#pragma once

#include <memory>

#include "ui/report/pictures.h"
#include "ui/report/report_pictures.h"

namespace feedscope::ui {

/// The place of a card, with a lens where it is a corner that several runs take.
struct PlaceShot {
  SlowPlace place;
  std::shared_ptr<const LensShot> lens;  ///< null: the place as it is
};
/// What the card with this number, from 1, shows. Throws InputError for one that the report does not have.
/// `input` as of with_time_report().
PlaceShot place_shot(const ReportInput& input, std::size_t number);

/// Name of the picture of the card that a group of places leads; "" without one.
QString card_picture_of(const TimeReport& report, const SlowGroup& group);

/// A card for each thing that the current run loses time to, that which loses most first: what its places
/// have in common, the worst of them explained, and that one in a picture. Where there are few such things,
/// further places of them.
QString cards_block(const ReportInput& input, ReportPictures& pictures);

}  // namespace feedscope::ui
