#pragma once

#include <QJsonObject>

#include "ui/charts/charts_state.h"
#include "ui/circular/circular_state.h"
#include "ui/program_text/program_view.h"
#include "ui/scene/scene_state.h"

namespace feedscope::ui {

class MainWindow;

/// What the user has set in the window's panels, apart from their layout.
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
/// What is missing or wrong stays as it is in `states`.
void read_json(const QJsonObject& json, PanelStates& states);

/// Keeps for the next start what belongs to no program.
void keep_panel_states(MainWindow& window);
/// Gives back what was kept; nothing kept, or nothing readable: all stays as it is.
void restore_panel_states(MainWindow& window);

}  // namespace feedscope::ui
