#include "ui/circular/circular_table.h"

#include <utility>

#include "ui/circular/polar_plot.h"
#include "ui/language/shown_numbers.h"

namespace feedscope::ui {

namespace {

QString error_number(double value) {
  constexpr double shown_as_zero = 5e-6;  // [mm]
  return number_text(std::abs(value) < shown_as_zero ? 0 : value, Dimension::error, 2);
}

QString error_number(const std::optional<double>& value) {
  return value ? error_number(*value) : QStringLiteral("–");
}

QString length_number(double value) {
  constexpr double shown_as_zero = 5e-4;  // [mm]
  return number_text(std::abs(value) < shown_as_zero ? 0 : value, Dimension::length);
}

}  // namespace

void CircularTable::set_tests(std::vector<CircularTest> tests) {
  beginResetModel();
  tests_ = std::move(tests);
  rows_.clear();
  for (std::size_t test = 0; test < tests_.size(); ++test) {
    for (std::size_t pass = 0; pass < tests_[test].passes.size(); ++pass) {
      rows_.push_back({test, pass});
    }
  }
  endResetModel();
}

int CircularTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int CircularTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QString CircularTable::text(const Row& row, int column) const {
  const CircularTest& test = tests_[row.test];
  const CirclePass& pass = test.passes[row.pass];
  const Circularity& found = pass.circularity;
  switch (column) {
    case line:
      return test.of_program() ? circle_lines(pass) : QString();
    case center:
      return QStringLiteral("%1 / %2 / %3")
          .arg(length_number(test.center.x()), length_number(test.center.y()),
               length_number(test.center.z()));
    case radius:
      return QStringLiteral("%1 %2").arg(length_number(test.request.radius),
                                         QString::fromLatin1(info_of(test.request.plane).name.data()));
    case feed:
      return number_text(test.request.feed, Dimension::feed, 0);
    case reached:
      return number_text(pass.reached_feed, Dimension::feed, 0);
    case direction:
      return pass.counter_clockwise ? tr("ccw") : tr("cw");
    case zone:
      return error_number(found.zone);
    case squares:
      return error_number(found.by_squares);
    case largest:
      return error_number(found.largest);
    case smallest:
      return error_number(found.smallest);
    case mean:
      return error_number(test.mean_deviation(pass));
    case both:
      return error_number(test.g_b());
    default:
      return error_number(test.d());
  }
}

QVariant CircularTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      return text(rows_[static_cast<std::size_t>(index.row())], index.column());
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignVCenter | (index.column() == direction ? Qt::AlignLeft : Qt::AlignRight));
    default:
      return {};
  }
}

QVariant CircularTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  const bool is_tip = role == Qt::ToolTipRole;
  const auto measure = [](const char* letters) {
    return with_unit_of(QString::fromLatin1(letters), Dimension::error);
  };
  switch (section) {
    case line:
      return is_tip ? tr("First and last program line of the circle") : tr("Line");
    case center:
      return is_tip ? tr("Programmed centre: X, Y and Z of the tool centre")
                    : with_unit_of(tr("Centre"), Dimension::length);
    case radius:
      return is_tip ? tr("Programmed radius, and plane of the circle")
                    : with_unit_of(tr("Radius"), Dimension::length);
    case feed:
      return is_tip ? tr("Programmed feed") : with_unit_of(tr("Feed"), Dimension::feed);
    case reached:
      return is_tip ? tr("Largest feed on the circle") : with_unit_of(tr("Reached"), Dimension::feed);
    case direction:
      return is_tip ? tr("Counter-clockwise (ccw) or clockwise (cw), from the first axis of the plane")
                    : tr("Direction");
    case zone:
      return is_tip ? tr("Circular error: least separation of two concentric circles that hold the path")
                    : measure("G");
    case squares:
      return is_tip ? tr("The same about the centre of the least-squares circle") : measure("G_ls");
    case largest:
      return is_tip ? tr("Largest deviation from the nominal radius at the programmed centre")
                    : measure("F_max");
    case smallest:
      return is_tip ? tr("Least deviation from the nominal radius at the programmed centre")
                    : measure("F_min");
    case mean:
      return is_tip ? tr("Mean radius of this direction less the nominal one") : measure("F_mean");
    case both:
      return is_tip ? tr("Circular error of both directions together") : measure("G(b)");
    default:
      return is_tip ? tr("Mean radius of both directions less the nominal one") : measure("D");
  }
}

}  // namespace feedscope::ui
