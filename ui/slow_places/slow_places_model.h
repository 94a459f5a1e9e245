#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/slow_places.h"

namespace feedscope::ui {

/// The places of a run that lose most time, the worst first.
class SlowPlacesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { loss, share, lines, feed, cause, columns };
  static constexpr std::size_t default_most = 100;

  using QAbstractTableModel::QAbstractTableModel;

  /// Null: none.
  void set_places(std::shared_ptr<const SlowPlaces> places);
  /// How many are listed.
  void set_most(std::size_t most);

  const SlowPlaces* places() const { return places_.get(); }
  const SlowPlace& place(int row) const;
  /// The row of the listed place whose slowest instant comes next after (or before) a time [s]; beyond the
  /// last one the first. -1: nothing is listed.
  int next_row(double time, bool forward) const;
  double listed_loss() const;  ///< of what is listed [s]

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void choose();
  QString text(const SlowPlace& place, int column) const;
  QString tip(const SlowPlace& place) const;

  std::shared_ptr<const SlowPlaces> places_;
  std::vector<std::uint32_t> rows_;  ///< indices of places, by loss
  std::size_t most_ = default_most;
};

}  // namespace feedscope::ui
