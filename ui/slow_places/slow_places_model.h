#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

#include "core/analysis/time/slow_places.h"

namespace feedscope::ui {

/// The places of a run with the largest loss of time, the worst first.
class SlowPlacesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { loss, share, lines, feed, cause, columns };
  static constexpr std::size_t default_most = 100;

  using QAbstractTableModel::QAbstractTableModel;

  /// Null: none.
  void set_places(std::shared_ptr<const SlowPlaces> places);
  /// Largest number of listed places.
  void set_most(std::size_t most);

  const SlowPlaces* places() const { return places_.get(); }
  const SlowPlace& place(int row) const;
  /// The row of the listed place with the next slowest instant after (or before) a time [s]; after the last
  /// one, the first. -1 if the list is empty.
  int next_row(double time, bool forward) const;
  double listed_loss() const;  ///< of the listed places [s]

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
