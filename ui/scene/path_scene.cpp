#include "ui/scene/path_scene.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <array>

#include "ui/scene/annotations.h"
#include "ui/scene/axes_box.h"
#include "ui/scene/path_layers.h"
#include "ui/scene/pick.h"
#include "ui/scene/sampled_path.h"
#include "ui/scene/scene_camera.h"
#include "ui/scene/tool_marker.h"

namespace feedscope::ui {

/// Two layers of one window: behind, the frame's grid and labels; in front, the path with legend and panel.
class PathScene::Impl {
 public:
  Impl()
      : under_(*behind_),
        over_(*front_),
        layers_(*front_),
        tool_(*front_),
        camera_(*front_->GetActiveCamera()) {
    behind_->SetBackground(palette::background[0], palette::background[1], palette::background[2]);
    behind_->SetLayer(0);
    behind_->InteractiveOff();
    front_->SetLayer(1);
    const vtkNew<vtkCallbackCommand> before;
    before->SetClientData(this);
    before->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->prepare(); });
    behind_->AddObserver(vtkCommand::StartEvent, before);
    camera_.look(StandardView::iso);
  }

  void attach(vtkRenderWindow& window) {
    window_ = &window;
    window.SetNumberOfLayers(2);
    window.AddRenderer(behind_);
    window.AddRenderer(front_);
  }

  void detach() {
    if (window_ != nullptr) {
      window_->RemoveRenderer(front_);
      window_->RemoveRenderer(behind_);
    }
    window_ = nullptr;
  }

  void on_change(std::function<void()> callback) { changed_ = std::move(callback); }

  void set_programmed(std::shared_ptr<const SampledPath> samples) {
    programmed_ = std::move(samples);
    rebuild();
  }

  void set_executed(std::shared_ptr<const Trajectory> trajectory,
                    std::shared_ptr<const SampledPath> samples) {
    trajectory_ = std::move(trajectory);
    executed_ = std::move(samples);
    rebuild();
  }

  void set_cursor(const std::optional<Vec3>& tip) {
    cursor_ = tip;
    changed();
  }

  void set_standard_view(StandardView view) {
    camera_.look(view);
    fit();
  }

  void fit() {
    fit_now();
    changed();
  }

  void set_scale(double scale) {
    scale_ = scale;
    changed();
  }

  std::optional<double> pick_time(const Pixel& pixel, double radius) const {
    if (!executed_ || !trajectory_) {
      return std::nullopt;
    }
    const Vec2 display(pixel[0], height() - pixel[1]);
    return nearest_time(*executed_, *trajectory_, {projection(), frame_}, display, radius * scale_);
  }

  Pixel pixel_of(const Vec3& point) const {
    const Vec2 display = projection().to_display(frame_.to_scene(point));
    return {display.x(), height() - display.y()};
  }

 private:
  int width() const { return window_ != nullptr ? std::max(1, window_->GetSize()[0]) : 1; }
  int height() const { return window_ != nullptr ? std::max(1, window_->GetSize()[1]) : 1; }
  Projection projection() const { return camera_.projection(width(), height()); }
  ScreenLayout layout() const {
    return screen_layout(width(), height(), scale_, layers_.entries(), layers_.top_feed() > 0);
  }

  void changed() const {
    if (changed_) {
      changed_();
    }
  }

  void rebuild() {
    const bool fitted = camera_.fitted();
    Bounds content;
    for (const auto& path : {programmed_, executed_}) {
      if (path && !path->bounds.empty()) {
        content.add(path->bounds.min);
        content.add(path->bounds.max);
      }
    }
    frame_ = frame_around(content);
    layers_.show(programmed_, executed_, frame_);
    if (fitted) {
      fit_now();
    }
    changed();
  }

  void fit_now() {
    const ScreenLayout screen = layout();
    camera_.fit(width(), height(), frame_.box, {screen.low(), screen.high()}, [this](const Projection& view) {
      const AxesLayout axes = lay_out_axes(frame_, view, scale_);
      return ScreenRectangle{axes.low, axes.high};
    });
    fitted_size_ = {width(), height()};
    fitted_scale_ = scale_;
  }

  /// Before each frame: follows the window's size and draws what depends on the camera.
  void prepare() {
    if (camera_.fitted() && (fitted_size_ != std::array{width(), height()} || fitted_scale_ != scale_)) {
      fit_now();
    }
    const Projection view = projection();
    const std::optional<Vec3> tip = cursor_ ? std::optional(frame_.to_scene(*cursor_)) : std::nullopt;
    layers_.place(frame_, view, scale_);
    tool_.place(tip, view, scale_);
    camera_.set_clipping(ToolMarker::reach(view, scale_));

    under_.begin();
    draw(lay_out_axes(frame_, view, scale_), scale_, under_);
    under_.end();
    over_.begin();
    const auto& path = executed_ ? executed_ : programmed_;
    if (path && path->size() > 0) {
      draw_start_marker(over_, view.to_display(frame_.to_scene(path->origin)), scale_);
    }
    draw_annotations(over_, layout(), layers_.entries(), view, view.scale / frame_.unit, layers_.top_feed());
    over_.end();
  }

  vtkNew<vtkRenderer> behind_;
  vtkNew<vtkRenderer> front_;
  Canvas under_;
  Canvas over_;
  PathLayers layers_;
  ToolMarker tool_;
  SceneCamera camera_;
  vtkWeakPointer<vtkRenderWindow> window_;
  std::function<void()> changed_;

  std::shared_ptr<const SampledPath> programmed_;
  std::shared_ptr<const SampledPath> executed_;
  std::shared_ptr<const Trajectory> trajectory_;
  std::optional<Vec3> cursor_;
  SceneFrame frame_ = frame_around({});
  double scale_ = 1;
  std::array<int, 2> fitted_size_{};
  double fitted_scale_ = 0;
};

PathScene::PathScene() : impl_(std::make_unique<Impl>()) {}
PathScene::~PathScene() = default;

void PathScene::attach(vtkRenderWindow& window) {
  impl_->attach(window);
}
void PathScene::detach() {
  impl_->detach();
}
void PathScene::on_change(std::function<void()> callback) {
  impl_->on_change(std::move(callback));
}
void PathScene::set_programmed(std::shared_ptr<const Toolpath> toolpath) {
  impl_->set_programmed(toolpath ? std::make_shared<const SampledPath>(sample_programmed(*toolpath))
                                 : nullptr);
}
void PathScene::set_programmed(std::shared_ptr<const SampledPath> samples) {
  impl_->set_programmed(std::move(samples));
}
void PathScene::set_executed(std::shared_ptr<const Trajectory> trajectory) {
  auto samples = trajectory ? std::make_shared<const SampledPath>(sample_executed(*trajectory)) : nullptr;
  impl_->set_executed(std::move(trajectory), std::move(samples));
}
void PathScene::set_executed(std::shared_ptr<const Trajectory> trajectory,
                             std::shared_ptr<const SampledPath> samples) {
  impl_->set_executed(std::move(trajectory), std::move(samples));
}
void PathScene::set_cursor(const std::optional<Vec3>& tip) {
  impl_->set_cursor(tip);
}
void PathScene::set_standard_view(StandardView view) {
  impl_->set_standard_view(view);
}
void PathScene::fit() {
  impl_->fit();
}
void PathScene::set_scale(double scale) {
  impl_->set_scale(scale);
}
std::optional<double> PathScene::pick_time(const Pixel& pixel, double radius) const {
  return impl_->pick_time(pixel, radius);
}
Pixel PathScene::pixel_of(const Vec3& point) const {
  return impl_->pixel_of(point);
}

}  // namespace feedscope::ui
