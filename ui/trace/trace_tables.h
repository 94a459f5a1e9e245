#pragma once

#include <QString>
#include <QStringList>

#include "ui/workbench/trace_list.h"

class QStandardItemModel;

namespace feedscope::ui {

/// Role of a table row's place on the programmed path [mm]; none: no place.
inline constexpr int trace_place_role = Qt::UserRole;
/// Role of the shown length on both sides of it [mm].
inline constexpr int trace_reach_role = Qt::UserRole + 1;

/// Times, feeds and distances of a trace compared with its run: title, trace, simulated, difference.
void fill_figures(QStandardItemModel& table, const ShownTrace& shown);
/// Places with the largest differences of trace and run, the largest difference of time first.
void fill_worst_places(QStandardItemModel& table, const ShownTrace& shown);
/// The corners, those with the largest difference of speed first; at most 200.
void fill_corners(QStandardItemModel& table, const ShownTrace& shown);
/// Leaves headings without rows.
void clear_tables(QStandardItemModel& figures, QStandardItemModel& places, QStandardItemModel& corners);

/// Agreement of the run, in one sentence.
QString verdict_of(const ShownTrace& shown);
/// Notes on the trace: on reading, smoothing and matching it to the program.
QStringList remarks_of(const ShownTrace& shown);

}  // namespace feedscope::ui
