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

// What the charts show, as files. Each is written as a whole or not at all; all throw InputError with the
// file and the reason where it cannot be written.

/// One row a time [s], ascending, with the columns of `simulate --csv`. `sources` as for write_csv().
void save_csv(const QString& file, const Trajectory& trajectory, std::span<const double> times,
              const RunSources& sources = {});
/// Times from one instant to another, `step` apart, and the other instant itself [s]. Throws InputError if
/// they are more than 20 million.
std::vector<double> sample_times(const Interval& range, double step);

/// Times at which blocks begin between two instants, and the two instants themselves [s].
std::vector<double> block_times(const Trajectory& trajectory, const Interval& range);

/// Bytes that are there already.
void write_whole_file(const QString& file, const QByteArray& bytes);

using DrawPicture = std::function<void(QPainter&)>;
/// `size` in logical pixels, `scale` pixels of the file to each.
void save_png(const QString& file, QSize size, double scale, const DrawPicture& draw);
void save_svg(const QString& file, QSize size, const QString& title, const DrawPicture& draw);

}  // namespace feedscope::ui
