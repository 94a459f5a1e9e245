#pragma once

#include <QJsonObject>

#include "ui/charts/charts_state.h"
#include "ui/circular/circular_state.h"
#include "ui/program_text/program_view.h"
#include "ui/scene/scene_state.h"

namespace feedscope::ui {

class MainWindow;

/// The user's settings of the window's panels, apart from their layout.
struct PanelStates {
  SceneState scene;
  ChartsState charts;
  CircularState circular;
  int program_font_size = ProgramView::default_font_size;  ///< [pixels]

  bool operator==(const PanelStates&) const = default;
};

PanelStates panel_states(MainWindow& window);
void set_panel_states(MainWindow& window, const PanelStates& states);

QJsonObject to_json(const PanelStates& states);
/// Missing or wrong values leave `states` unchanged.
void read_json(const QJsonObject& json, PanelStates& states);

/// Stores settings that do not belong to a program for the next start.
void keep_panel_states(MainWindow& window);
/// Restores the stored settings; without valid ones nothing changes.
void restore_panel_states(MainWindow& window);

}  // namespace feedscope::ui
