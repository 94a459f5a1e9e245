#pragma once

#include <QString>
#include <QStringList>

#include "ui/workbench/trace_list.h"

class QStandardItemModel;

namespace feedscope::ui {

/// Role of the place on the programmed path that a row of a table stands for [mm]; none: no place.
inline constexpr int trace_place_role = Qt::UserRole;
/// Role of how far to both sides it is to be shown [mm].
inline constexpr int trace_reach_role = Qt::UserRole + 1;

/// Times, feeds and distances of a trace beside its run: what, trace, simulated, difference.
void fill_figures(QStandardItemModel& table, const ShownTrace& shown);
/// Where trace and run differ most, the largest difference of time first.
void fill_worst_places(QStandardItemModel& table, const ShownTrace& shown);
/// The corners, those first whose speeds differ most; at most 200.
void fill_corners(QStandardItemModel& table, const ShownTrace& shown);
/// Headings without rows.
void clear_tables(QStandardItemModel& figures, QStandardItemModel& places, QStandardItemModel& corners);

/// How well the run agrees, in one sentence.
QString verdict_of(const ShownTrace& shown);
/// What is to be known about the trace: how it was read, smoothed and laid beside the program.
QStringList remarks_of(const ShownTrace& shown);

}  // namespace feedscope::ui
