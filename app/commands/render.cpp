#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/output_file.h"
#include "app/picture_size.h"
#include "app/print.h"
#include "app/run_options.h"
#include "app/watch.h"
#include "ui/scene/picture.h"
#include "ui/window_picture.h"

namespace feedscope {
namespace {

const std::map<std::string, ui::StandardView> cameras{{"iso", ui::StandardView::iso},
                                                      {"top", ui::StandardView::top},
                                                      {"front", ui::StandardView::front},
                                                      {"right", ui::StandardView::right}};

struct RenderOptions {
  RunOptions run;
  std::string view = "3d";
  std::string size = "1280x960";
  std::string camera = "iso";
  std::string theme = "light";
  std::string out;
};

const std::map<std::string, ui::ThemeKind> themes{{"light", ui::ThemeKind::light},
                                                  {"dark", ui::ThemeKind::dark}};

using Draw = std::function<ui::Picture(const Run&, ui::PictureSize, const ui::WindowLook&)>;

const std::map<std::string, Draw> views{
    {"3d", [](const Run& run, ui::PictureSize size,
              const ui::WindowLook& look) { return ui::draw_run(run, size, look.view); }},
    {"charts",
     [](const Run& run, ui::PictureSize size, const ui::WindowLook&) { return ui::draw_charts(run, size); }},
    {"window", [](const Run& run, ui::PictureSize size, const ui::WindowLook& look) {
       return ui::draw_window(run, size, look);
     }}};

int render(const RenderOptions& options) {
  const ui::PictureSize size = parse_picture_size(options.size);
  const Setup setup = make_setup(options.run.request());
  note_unused_tolerance(options.run, setup);
  check_outputs(options.run.file, {options.out});
  const auto source = std::make_shared<const SourceText>(SourceText::from_file(options.run.file));
  OutputFile out(options.out);
  Run run;
  {
    Watch watch;
    const LoadedProgram program = load_program(source, watch.stage("reading"), options.run.reading());
    run = simulate_run(program, setup, watch.stage("simulating"));
  }
  out.stream() << ui::to_png(
      views.at(options.view)(run, size, {cameras.at(options.camera), themes.at(options.theme)}));
  out.commit();
  if (!options.run.tolerance.empty()) {
    note_replaced_tolerance(*run.input.toolpath);
  }
  print_diagnostics(*run.input.program);
  return has_errors(run.input.program->diagnostics) ? exit_code::program_errors : exit_code::done;
}

}  // namespace

Command add_render_command(CLI::App& app) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      app.add_subcommand("render", "Draw an NC program and its motion as a PNG picture; needs no display");
  add_run_options(*command, options->run);
  command->add_option("--view", options->view, "What to draw: 3d, charts, window")
      ->check(CLI::IsMember(views))
      ->type_name("VIEW")
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and height in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command->add_option("--camera", options->camera, "Where to look from: iso, top, front, right")
      ->check(CLI::IsMember(cameras))
      ->type_name("CAMERA")
      ->capture_default_str();
  command->add_option("--theme", options->theme, "Colours of the window: light, dark")
      ->check(CLI::IsMember(themes))
      ->type_name("THEME")
      ->capture_default_str();
  command->add_option("--out", options->out, "The picture to write; - for standard output")
      ->type_name("FILE.png")
      ->required();
  return {command, [options] { return render(*options); }};
}

}  // namespace feedscope
