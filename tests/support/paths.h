#pragma once

#include <random>
#include <vector>

#include "core/machine/machine.h"
#include "core/models/control_model.h"
#include "core/toolpath/toolpath.h"

namespace feedscope::testing {

/// Lines through `points` at `feed` [mm/s]; line numbers count from 1.
Toolpath polyline(const std::vector<Vec3>& points, double feed);

/// Appends a line or an arc that goes on tangentially where it can.
void append_line(Toolpath& path, const Vec3& end, double feed);
/// Flat arc in XY about `center`, counter-clockwise for sweep > 0 [rad].
void append_arc(Toolpath& path, const Vec3& center, double sweep, double feed);
/// Waits for `time` [s].
void append_dwell(Toolpath& path, double time);

/// `count` arcs of `sweep` [rad], counter-clockwise, that begin in the direction `from` [rad] seen from the
/// first centre, at the origin; their radii grow from `radius` by `step` [mm] and they join tangentially.
Toolpath spiral(double radius, double step, int count, double from, double sweep, double feed);

/// Corners of all sizes, short and long blocks, collinear runs, reversals, arcs, helices, feeds 1 to 60 000
/// mm/min. `blocks` segments; coordinates in mm.
Toolpath random_path(std::mt19937& random, int blocks);

/// The Spinner MVC 850 of Essid 2019, table 2 (Z as X and Y).
Machine spinner();
/// Settings of `model` for the tests of Essid 2019: rho 0.1 mm, t_s 1 ms, 8 blocks, R_A = R_J = 0.2.
Settings spinner_settings(const ControlModel& model);

/// The Mikron UCP 710 of Tapie 2007, table 1.
Machine mikron();

/// Points of Essid 2019, table 1 [mm].
std::vector<Vec3> essid_table1();
/// The spline of Essid 2019, eq 32, at the parameters of models/essid/README.md [mm].
std::vector<Vec3> essid_spline();

}  // namespace feedscope::testing
