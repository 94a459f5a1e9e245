#include "ui/slow_places/slow_places_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/units.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/next_place.h"

namespace feedscope::ui {

namespace {

QString feed_text(double feed) {
  return number_text(std::abs(feed), Dimension::feed);  // no minus sign before a rounded 0
}

}  // namespace

void SlowPlacesModel::set_places(std::shared_ptr<const SlowPlaces> places) {
  beginResetModel();
  places_ = std::move(places);
  choose();
  endResetModel();
}

void SlowPlacesModel::set_most(std::size_t most) {
  beginResetModel();
  most_ = most;
  choose();
  endResetModel();
}

void SlowPlacesModel::choose() {
  rows_.resize(places_ == nullptr ? 0 : places_->places.size());
  std::iota(rows_.begin(), rows_.end(), 0);
  const auto loss_of = [this](std::uint32_t i) { return places_->places[i].loss; };
  std::ranges::stable_sort(rows_, std::ranges::greater(), loss_of);
  rows_.resize(std::min(rows_.size(), most_));
}

const SlowPlace& SlowPlacesModel::place(int row) const {
  return places_->places[rows_[static_cast<std::size_t>(row)]];
}

int SlowPlacesModel::next_row(double time, bool forward) const {
  return next_place(
      rowCount(), [this](int row) { return place(row).slowest; }, time, forward);
}

double SlowPlacesModel::listed_loss() const {
  return std::accumulate(rows_.begin(), rows_.end(), 0.0,
                         [this](double sum, std::uint32_t i) { return sum + places_->places[i].loss; });
}

int SlowPlacesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SlowPlacesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QString SlowPlacesModel::text(const SlowPlace& place, int column) const {
  const QLocale locale;
  constexpr double percent = 100;
  switch (column) {
    case loss:
      return locale.toString(place.loss, 'f', 4);
    case share:
      return locale.toString(percent * place.loss / places_->loss, 'f', 1);
    case lines:
      return place.first_line == place.last_line
                 ? QString::number(place.line)
                 : tr("%1 – %2").arg(QString::number(place.first_line), QString::number(place.last_line));
    case feed:
      return tr("%1 of %2").arg(feed_text(place.feed), feed_text(place.programmed_feed));
    default:
      return shown_cause(place.cause);
  }
}

QString SlowPlacesModel::tip(const SlowPlace& place) const {
  const QLocale locale;
  return tr("From %1 s to %2 s, slowest at %3 s in line %4.\n%5 s lost against the programmed feed, mostly "
            "due to: %6.")
      .arg(locale.toString(place.from, 'f', 4), locale.toString(place.to, 'f', 4),
           locale.toString(place.slowest, 'f', 4), QString::number(place.line),
           locale.toString(place.loss, 'f', 4), shown_cause(place.cause));
}

QVariant SlowPlacesModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      return text(place(index.row()), index.column());
    case Qt::ToolTipRole:
      return tip(place(index.row()));
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignVCenter | (index.column() == cause ? Qt::AlignLeft : Qt::AlignRight));
    default:
      return {};
  }
}

QVariant SlowPlacesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case loss:
      return tr("Lost [s]");
    case share:
      return tr("Share [%]");
    case lines:
      return tr("Lines");
    case feed:
      return with_unit_of(tr("Slowest feed"), Dimension::feed);
    default:
      return tr("Cause");
  }
}

}  // namespace feedscope::ui
