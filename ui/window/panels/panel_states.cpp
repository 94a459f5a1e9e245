#include "ui/window/panels/panel_states.h"

#include <QJsonDocument>
#include <QSettings>

#include "ui/charts/charts_panel.h"
#include "ui/circular/circular_view.h"
#include "ui/program_text/program_panel.h"
#include "ui/scene_view/scene_json.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/presentation.h"

namespace feedscope::ui {

namespace {

const QString settings_key = QStringLiteral("panels");

}  // namespace

PanelStates panel_states(MainWindow& window) {
  return {window.scene().state(), window.part<ChartsPanel>().state(), window.part<CircularView>().state(),
          window.presentation().usual_program_type()};
}

void set_panel_states(MainWindow& window, const PanelStates& states) {
  window.scene().set_state(states.scene);
  window.part<ChartsPanel>().set_state(states.charts);
  window.part<CircularView>().set_state(states.circular);
  window.part<ProgramPanel>().view().set_font_size(states.program_font_size);
}

QJsonObject to_json(const PanelStates& states) {
  return {{"scene", to_json(states.scene)},
          {"charts", to_json(states.charts)},
          {"circular", to_json(states.circular)},
          {"program_font_px", states.program_font_size}};
}

void read_json(const QJsonObject& json, PanelStates& states) {
  read_json(json["scene"].toObject(), states.scene);
  read_json(json["charts"].toObject(), states.charts);
  read_json(json["circular"].toObject(), states.circular);
  states.program_font_size = json["program_font_px"].toInt(states.program_font_size);
}

void keep_panel_states(MainWindow& window) {
  PanelStates states = panel_states(window);
  states.scene = for_any_path(states.scene);
  if (needs_reference(states.scene.colouring)) {
    states.scene.colouring = Colouring::feed;  // the next program has one run at first
  }
  states.charts = for_any_run(states.charts);
  QSettings().setValue(settings_key, QJsonDocument(to_json(states)).toJson(QJsonDocument::Compact));
}

void restore_panel_states(MainWindow& window) {
  PanelStates states = panel_states(window);
  read_json(QJsonDocument::fromJson(QSettings().value(settings_key).toByteArray()).object(), states);
  set_panel_states(window, states);
}

}  // namespace feedscope::ui
