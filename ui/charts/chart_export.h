#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <functional>
#include <span>

#include "core/drives/drive_response.h"
#include "core/trajectory/trajectory.h"
#include "ui/charts/value_fit.h"

class QPainter;

namespace feedscope::ui {

// Contents of the charts as files. Each is written as a whole or not at all; all throw InputError with the
// file and the reason if it cannot be written.

/// A row for each time [s], ascending, with the columns of `simulate --csv`. `sources` as for write_csv().
void save_csv(const QString& file, const Trajectory& trajectory, std::span<const double> times,
              const RunSources& sources = {});
/// Times over the range, `step` apart, and its end [s]. Throws InputError for more than 20 million.
std::vector<double> sample_times(const Interval& range, double step);

/// Times in the range at which blocks begin, and both its ends [s].
std::vector<double> block_times(const Trajectory& trajectory, const Interval& range);

/// Writes `bytes` to `file`.
void write_whole_file(const QString& file, const QByteArray& bytes);

/// PNG with two pixels per logical pixel of `size`, SVG or PDF, by the ending of the file's name.
void save_picture(const QString& file, QSize size, const QString& title,
                  const std::function<void(QPainter&)>& draw);

}  // namespace feedscope::ui
