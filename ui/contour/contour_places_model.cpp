#include "ui/contour/contour_places_model.h"

#include <QFont>
#include <QLocale>
#include <utility>

#include "ui/contour/contour_texts.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/next_place.h"

namespace feedscope::ui {

namespace {

QString feed_text(double feed) {
  return number_text(feed, Dimension::feed);
}

bool is_exceeded(const ContourFinding& finding) {
  return finding.tolerance && !keeps_tolerance(finding.place.error, *finding.tolerance);
}

}  // namespace

void ContourPlacesModel::set_report(std::shared_ptr<const ContourReport> report) {
  beginResetModel();
  report_ = std::move(report);
  endResetModel();
}

int ContourPlacesModel::next_row(double time, bool forward) const {
  return next_place(
      rowCount(), [this](int row) { return finding(row).place.time; }, time, forward);
}

int ContourPlacesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || report_ == nullptr ? 0 : static_cast<int>(report_->worst.size());
}

int ContourPlacesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QString ContourPlacesModel::text(int row, int column) const {
  const QLocale locale;
  const ContourFinding& found = finding(row);
  constexpr double percent = 100;
  switch (column) {
    case rank:
      return locale.toString(row + 1);
    case line:
      return line_text(found);
    case error:
      return error_text(found.place.error);
    case share:
      return found.tolerance && *found.tolerance > 0
                 ? locale.toString(percent * found.place.error / *found.tolerance, 'f', 0)
                 : QStringLiteral("–");
    case side:
      return side_text(found.place);
    case spot:
      return spot_text(found.spot);
    case feed:
      return tr("%1 of %2").arg(feed_text(found.feed), feed_text(found.programmed_feed));
    default:
      return shown_cause(found.cause);
  }
}

QString ContourPlacesModel::tip(const ContourFinding& found) const {
  const QLocale locale;
  const Vec3& at = found.place.position;
  QString tip = tr("%1 from the programmed path at %2, X %3 Y %4 Z %5.")
                    .arg(error_amount_text(found.place.error), clock_text(found.place.time),
                         number_text(at.x(), Dimension::length), number_text(at.y(), Dimension::length),
                         amount_text(at.z(), Dimension::length));
  if (found.tolerance) {
    tip += QStringLiteral("\n") + (is_exceeded(found) ? tr("The contour tolerance of %1 is exceeded here.")
                                                      : tr("The contour tolerance of %1 is kept here."))
                                      .arg(error_amount_text(*found.tolerance));
  }
  return tip;
}

QVariant ContourPlacesModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const ContourFinding& found = finding(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(index.row(), index.column());
    case Qt::ToolTipRole:
      return tip(found);
    case Qt::FontRole: {
      QFont font;
      font.setBold(true);
      return is_exceeded(found) ? QVariant(font) : QVariant();
    }
    case Qt::TextAlignmentRole: {
      const bool is_words = index.column() == side || index.column() == spot || index.column() == cause;
      return QVariant(Qt::AlignVCenter | (is_words ? Qt::AlignLeft : Qt::AlignRight));
    }
    default:
      return {};
  }
}

QVariant ContourPlacesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  const bool is_tip = role == Qt::ToolTipRole;
  switch (section) {
    case rank:
      return is_tip ? tr("Rank by contour error") : tr("No.");
    case line:
      return is_tip ? tr("Program line and block number") : tr("Line");
    case error:
      return is_tip ? tr("Distance of the executed path from the programmed one")
                    : with_unit_of(tr("Error"), Dimension::error);
    case share:
      return is_tip ? tr("Share of the contour tolerance that applies there") : tr("Used [%]");
    case side:
      return is_tip ? tr("Side of the programmed path in XY, in its direction: left is the G41 side")
                    : tr("Side");
    case spot:
      return is_tip ? tr("Shape of the programmed path there") : tr("Where");
    case feed:
      return is_tip ? tr("Achieved and programmed feed there") : with_unit_of(tr("Feed"), Dimension::feed);
    default:
      return is_tip ? tr("What limits the feed there") : tr("Limited by");
  }
}

}  // namespace feedscope::ui
