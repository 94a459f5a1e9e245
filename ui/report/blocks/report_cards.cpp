#include "ui/report/blocks/report_cards.h"

#include <fmt/format.h>

#include <QLocale>
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/analysis/explanation/explanation.h"
#include "core/analysis/notes/refused_lines.h"
#include "core/analysis/time/ruled_instant.h"
#include "core/base/error.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/time_texts.h"
#include "ui/paper/html_table.h"
#include "ui/report/pictures.h"
#include "ui/report/report_numbers.h"
#include "ui/report/report_words.h"
#include "ui/why/why_text.h"

namespace feedscope::ui {

namespace {

constexpr double card_picture_width = 416;  // 110 mm [1/96 inch]

/// A group and the rank of one of its worst places.
struct CardPlace {
  const SlowGroup* group = nullptr;
  std::size_t rank = 0;
  bool leads = false;  ///< whether it is the first card of its group

  const SlowPlace& place() const { return group->worst[rank]; }
};

/// The worst place of a group that is not in `cards`; none if all are.
std::optional<CardPlace> unseen_place(const SlowGroup& group, const std::vector<CardPlace>& cards) {
  for (std::size_t rank = 0; rank < group.worst.size(); ++rank) {
    const SlowPlace& place = group.worst[rank];
    if (std::ranges::none_of(cards, [&](const CardPlace& card) {
          return card.place().from < place.to && place.from < card.place().to;
        })) {
      return CardPlace{&group, rank};
    }
  }
  return std::nullopt;
}

/// At most five groups, without those whose places are all in another card; with fewer than three, further
/// places.
std::vector<CardPlace> card_places(const TimeReport& report) {
  constexpr std::size_t most = 5;
  constexpr std::size_t least = 3;
  constexpr double least_of_time = 2e-3;    // share of the cycle time
  constexpr double least_of_losses = 0.02;  // share of all that is lost
  const double worth_a_card =
      std::max(least_of_time * report.use.cycle_time, least_of_losses * report.slow.loss);
  std::vector<CardPlace> cards;
  for (const SlowGroup& group : report.slow.groups) {
    if (cards.size() < most && group.loss >= worth_a_card) {
      if (auto card = unseen_place(group, cards)) {
        card->leads = true;
        cards.push_back(*card);
      }
    }
  }
  const std::size_t groups = cards.size();
  for (std::size_t i = 0; groups > 0 && cards.size() < least && i < least * groups; ++i) {
    if (const auto another = unseen_place(*cards[i % groups].group, cards)) {
      cards.push_back(*another);
    }
  }
  return cards;
}

/// The places of the cards, then the others by loss.
std::vector<CardPlace> ranked_places(const TimeReport& report) {
  std::vector<CardPlace> places = card_places(report);
  const auto cards = static_cast<std::ptrdiff_t>(places.size());
  for (const SlowGroup& group : report.slow.groups) {
    while (const auto another = unseen_place(group, places)) {
      places.push_back(*another);
    }
  }
  std::ranges::stable_sort(places.begin() + cards, places.end(), std::greater(),
                           [](const CardPlace& one) { return one.place().loss; });
  return places;
}

/// Number of the card that leads the group of `card`.
std::size_t leading_card(const std::vector<CardPlace>& cards, const CardPlace& card) {
  const auto leader =
      std::ranges::find_if(cards, [&](const CardPlace& one) { return one.leads && one.group == card.group; });
  return static_cast<std::size_t>(leader - cards.begin()) + 1;
}

QString card_text(const ReportInput& input, const std::vector<CardPlace>& cards, std::size_t number) {
  const CardPlace& card = cards[number - 1];
  const Run& run = input.run().shown->run;
  const SlowGroup& group = *card.group;
  const SlowPlace& place = card.place();
  const QString title = card.leads ? html_text(TimeTexts::group(group))
                                   : ReportWords::tr("Another place of %1").arg(leading_card(cards, card));
  QString html = QStringLiteral("<h3>%1. %2</h3>\n").arg(number).arg(title);
  if (card.leads) {
    html +=
        paragraph(ReportWords::tr("<b>%1 lost</b>, %2 of all; %3.")
                      .arg(TimeTexts::gain(group.loss), TimeTexts::percent(group.loss, input.time->slow.loss),
                           html_text(TimeTexts::in_common(group))));
  }
  QString lines = place.first_line == place.last_line
                      ? ReportWords::tr("line %1").arg(place.first_line)
                      : ReportWords::tr("lines %1 to %2").arg(place.first_line).arg(place.last_line);
  if (card.rank != 0) {
    lines[0] = lines[0].toUpper();
  }
  const QString text = card.rank == 0 ? ReportWords::tr("The worst: %1, %2 lost, %3 of %4 %5.")
                                      : ReportWords::tr("%1, %2 lost, %3 of %4 %5.");
  html += paragraph(text.arg(lines, TimeTexts::gain(place.loss), fixed(place.feed, Dimension::feed),
                             fixed(place.programmed_feed, Dimension::feed), unit_of(Dimension::feed)));
  const Explanation why = explain(run, run.trajectory->state(ruled_instant(*run.trajectory, place)));
  return html + paragraph(WhyText::sentence(place.cause, why).toHtmlEscaped());
}

/// Corners of several runs through the lens, other places directly.
PlaceShot shot_of(const ReportInput& input, const CardPlace& card) {
  if (card.group->shape == PlaceShape::corner && input.runs.size() > 1) {
    LensShot shot = lens_shot(input, card.place().slowest);
    if (shot.lens.deviates) {
      shot.lens.line = card.place().line;  // a corner belongs to both of its lines: as in the texts
      return {card.place(), std::make_shared<const LensShot>(std::move(shot))};
    }
  }
  return {card.place(), nullptr};
}

ElasticPicture card_picture(const ReportInput& input, const CardPlace& card, double largest) {
  constexpr double least = 130;
  return {[input, shot = shot_of(input, card)](const QSizeF& size) {
            return shot.lens ? lens_picture(shot.lens, size)
                             : close_up(without_other_runs(input), shot.place, size);
          },
          least, largest};
}

/// Meaning of the lines in close-ups.
QString lines_key(const ReportInput& input) {
  QStringList parts{ReportWords::tr("thin grey the programmed path")};
  if (input.run().shown->run.trajectory->blend_count() > 0) {
    parts.append(ReportWords::tr("dark edges corner blends"));
  }
  if (!input.run().shown->samples->tool_axes.empty()) {
    parts.append(ReportWords::tr("pins the tool axis"));
  }
  parts.append(ReportWords::tr("pink the place and a circle its slowest point"));
  return ReportWords::tr("In pictures along the path: %1.").arg(parts.join(QStringLiteral(", ")));
}

QString card_name(std::size_t number) {
  return QStringLiteral("card%1").arg(number);
}

}  // namespace

QString card_picture_of(const TimeReport& report, const SlowGroup& group) {
  const std::vector<CardPlace> cards = card_places(report);
  const auto found =
      std::ranges::find_if(cards, [&](const CardPlace& card) { return card.leads && card.group == &group; });
  return found == cards.end() ? QString() : card_name(static_cast<std::size_t>(found - cards.begin()) + 1);
}

PlaceShot place_shot(const ReportInput& input, std::size_t number) {
  const std::vector<CardPlace> places =
      is_refused(input.run().shown->run) ? std::vector<CardPlace>() : ranked_places(*input.time);
  if (places.empty()) {
    throw InputError(
        "--place: the run loses no time to its programmed feed, so that there is no place to draw");
  }
  if (number < 1 || number > places.size()) {
    throw InputError(fmt::format("--place {}: the run has {} places that lose time; give 1 to {}", number,
                                 places.size(), places.size()));
  }
  return shot_of(input, places[number - 1]);
}

QString cards_block(const ReportInput& input, ReportPictures& pictures) {
  if (is_refused(input.run().shown->run)) {
    return {};
  }
  const std::vector<CardPlace> cards = card_places(*input.time);
  const double largest = cards.size() < 3 ? 390 : 290;  // to fill a page
  QString html =
      cards.empty() ? QString() : QStringLiteral("<p class=\"small\">%1</p>\n").arg(lines_key(input));
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const QString picture =
        pictures.add_elastic(card_name(i + 1), card_picture_width, card_picture(input, cards[i], largest),
                             ReportWords::tr("Place %1").arg(i + 1));
    html +=
        two_columns(card_text(input, cards, i + 1),
                    figure(picture, ReportWords::tr("Line %1.").arg(cards[i].place().line)), narrow_share);
  }
  return html;
}

}  // namespace feedscope::ui
