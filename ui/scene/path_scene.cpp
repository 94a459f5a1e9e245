#include "ui/scene/path_scene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "ui/scene/annotations.h"
#include "ui/scene/axes_box.h"
#include "ui/scene/path_actors.h"
#include "ui/scene/pick.h"
#include "ui/scene/sampled_path.h"
#include "ui/scene/ticks.h"

namespace feedscope::ui {
namespace {

constexpr double eye_distance = 40;  // scene units; parallel projection shows the same from anywhere

/// What the user sees change when the camera moves.
struct CameraPose {
  Vec3 focal, position, up;
  double parallel_scale = 0;

  explicit CameraPose(vtkCamera& camera)
      : focal(camera.GetFocalPoint()),
        position(camera.GetPosition()),
        up(camera.GetViewUp()),
        parallel_scale(camera.GetParallelScale()) {}
  bool operator==(const CameraPose&) const = default;
};

/// An actor of the path.
struct Layer {
  vtkSmartPointer<vtkActor> actor;
  double width = 1;            ///< of lines and points [pixels at scale 1]
  double height = 0;           ///< nearer to the eye than the path by this [pixels at scale 1]
  Vec3 origin = Vec3::Zero();  ///< of its points [mm]
};

}  // namespace

class PathScene::Impl {
 public:
  Impl() : under_(*behind_), over_(*front_) {
    behind_->SetBackground(palette::background[0], palette::background[1], palette::background[2]);
    behind_->SetLayer(0);
    behind_->InteractiveOff();
    front_->SetLayer(1);
    camera().ParallelProjectionOn();
    front_->AddActor(tool_);
    make_tool();
    const vtkNew<vtkCallbackCommand> before;
    before->SetClientData(this);
    before->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->prepare(); });
    behind_->AddObserver(vtkCommand::StartEvent, before);
    set_standard_view(StandardView::iso);
  }

  void attach(vtkRenderWindow& window) {
    window_ = &window;
    window.SetNumberOfLayers(2);
    window.AddRenderer(behind_);
    window.AddRenderer(front_);
  }

  void on_change(std::function<void()> callback) { changed_ = std::move(callback); }

  void set_programmed(std::shared_ptr<const Toolpath> toolpath) {
    programmed_ = toolpath ? std::make_shared<const SampledPath>(sample_programmed(*toolpath)) : nullptr;
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
    struct Pose {
      Vec3 towards, up;
    };
    const Pose pose = [view]() -> Pose {
      switch (view) {
        case StandardView::top:
          return {Vec3::UnitZ(), Vec3::UnitY()};
        case StandardView::front:
          return {-Vec3::UnitY(), Vec3::UnitZ()};
        case StandardView::right:
          return {Vec3::UnitX(), Vec3::UnitZ()};
        case StandardView::iso:
          break;
      }
      return {Vec3(1, -1, 1).normalized(), Vec3::UnitZ()};
    }();
    const Vec3 eye = eye_distance * pose.towards;
    camera().SetFocalPoint(0, 0, 0);
    camera().SetPosition(eye.x(), eye.y(), eye.z());
    camera().SetViewUp(pose.up.x(), pose.up.y(), pose.up.z());
    camera().OrthogonalizeViewUp();
    fit();
  }

  void fit() {
    fitted_ = true;
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
  vtkCamera& camera() const { return *front_->GetActiveCamera(); }
  int width() const { return window_ != nullptr ? std::max(1, window_->GetSize()[0]) : 1; }
  int height() const { return window_ != nullptr ? std::max(1, window_->GetSize()[1]) : 1; }
  Projection projection() const { return {camera(), width(), height()}; }

  void changed() const {
    if (changed_) {
      changed_();
    }
  }

  void make_tool() {
    const vtkNew<vtkConeSource> cone;  // tip at the origin, opening upwards
    cone->SetDirection(0, 0, -1);
    cone->SetHeight(1);
    cone->SetRadius(0.28);
    cone->SetCenter(0, 0, 0.5);
    cone->SetResolution(48);
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    tool_->SetMapper(mapper);
    tool_->GetProperty()->SetColor(palette::tool[0], palette::tool[1], palette::tool[2]);
    tool_->GetProperty()->SetAmbient(0.35);
    tool_->GetProperty()->SetDiffuse(0.75);
    tool_->SetVisibility(0);
  }

  void add_layer(vtkPolyData& lines, vtkSmartPointer<vtkActor> actor, double width, double height,
                 const Vec3& origin) {
    if (lines.GetNumberOfCells() == 0) {
      return;
    }
    front_->AddActor(actor);
    layers_.push_back({std::move(actor), width, height, origin});
  }

  void rebuild() {
    for (const Layer& layer : layers_) {
      front_->RemoveActor(layer.actor);
    }
    layers_.clear();
    entries_ = {};
    Bounds content;
    for (const auto& path : {programmed_, executed_}) {
      if (path && !path->bounds.empty()) {
        content.add(path->bounds.min);
        content.add(path->bounds.max);
      }
    }
    frame_ = frame_around(content);
    top_feed_ = 0;
    const std::shared_ptr<const SampledPath> rapids = programmed_ ? programmed_ : executed_;
    if (rapids) {
      const auto dashes = rapid_dashes(*rapids, frame_.unit / 90);
      entries_.rapid = dashes->GetNumberOfCells() > 0;
      add_layer(*dashes, line_actor(*dashes, palette::rapid), 1.4, 0, rapids->origin);
    }
    if (programmed_) {
      const auto lines = polylines(*programmed_, [](SpanKind kind) { return kind == SpanKind::cut; });
      entries_.programmed = lines->GetNumberOfCells() > 0;
      add_layer(*lines, line_actor(*lines, palette::programmed), 1.4, 1.5, programmed_->origin);
    }
    if (executed_) {
      add_executed();
    }
    if (fitted_) {
      fit_now();
    }
    changed();
  }

  void add_executed() {
    const auto lines = polylines(*executed_, [](SpanKind kind) { return kind != SpanKind::rapid; });
    const auto blends = polylines(*executed_, [](SpanKind kind) { return kind == SpanKind::blend; });
    entries_.executed = lines->GetNumberOfCells() > 0;
    entries_.blend = blends->GetNumberOfCells() > 0;
    if (entries_.executed) {
      const double peak = units::to_mm_min(executed_->peak_feed);
      const Ticks ticks = round_ticks(0, peak, 10);
      // Up to the next half step, so that the bar ends at a value one can name.
      const double half = ticks.step / 2;
      top_feed_ = half > 0 ? units::from_mm_min(std::ceil(peak / half - 1e-6) * half) : 0;
    }
    const auto colours = feed_colours(top_feed_);
    const auto joins = blend_points(*executed_);
    const Vec3& origin = executed_->origin;
    for (vtkPolyData* shape : {blends.Get(), joins.Get()}) {
      add_layer(*shape, line_actor(*shape, palette::blend_edge), 7, 3, origin);
      add_layer(*shape, line_actor(*shape, *colours), 4.4, 10, origin);
    }
    // A disc bulges towards the eye by half its width: 3 + 7 / 2 stays below 8.
    add_layer(*lines, line_actor(*lines, *colours), 2.6, 8, origin);
    start_ = executed_->position(0);
  }

  /// Centres and scales the camera so that the path with its axes fills the part of the window that is
  /// theirs.
  void fit_now() {
    if (window_ == nullptr || width() < 2 || height() < 2) {
      return;
    }
    const ScreenLayout screen = layout();
    const Vec2 room = (screen.high() - screen.low()).cwiseMax(Vec2::Constant(16));
    camera().SetFocalPoint(0, 0, 0);
    const Vec3 eye = eye_distance * projection().towards;
    camera().SetPosition(eye.x(), eye.y(), eye.z());
    // Labels do not scale with the path, so their room is known only after laying them out: three rounds
    // settle.
    Vec2 labels = Vec2::Constant(40 * scale_);
    Vec2 shift = Vec2::Zero();
    for (int round = 0; round < 4; ++round) {
      const Vec2 extent = projected_extent();
      const Vec2 free = (room - labels).cwiseMax(room / 4);
      const double pixels = std::min(extent.x() > 0 ? free.x() / extent.x() : free.y() / extent.y(),
                                     extent.y() > 0 ? free.y() / extent.y() : free.x() / extent.x());
      camera().SetParallelScale(height() / 2.0 / pixels);
      const AxesLayout axes = lay_out_axes(frame_, projection(), scale_);
      labels = (axes.high - axes.low) - pixels * extent;
      shift = (axes.low + axes.high) / 2 - (screen.low() + screen.high()) / 2;
    }
    const Projection view = projection();
    const Vec3 move = (shift.x() * view.right + shift.y() * view.up) / view.scale;
    camera().SetFocalPoint(move.x(), move.y(), move.z());
    const Vec3 moved_eye = eye + move;
    camera().SetPosition(moved_eye.x(), moved_eye.y(), moved_eye.z());
    fitted_pose_ = CameraPose(camera());
    fitted_size_ = {width(), height()};
    fitted_scale_ = scale_;
  }

  /// Of the box on the screen, in scene units.
  Vec2 projected_extent() const {
    const Projection view = projection();
    const Vec3 size = frame_.box.max - frame_.box.min;
    return {size.dot(view.right.cwiseAbs()), size.dot(view.up.cwiseAbs())};
  }

  ScreenLayout layout() const { return screen_layout(width(), height(), scale_, entries_, top_feed_ > 0); }

  /// Before each frame: follows the window's size, lifts the layers, draws what depends on the camera.
  void prepare() {
    if (fitted_ && fitted_pose_ && !(*fitted_pose_ == CameraPose(camera()))) {
      fitted_ = false;  // turned or moved by hand
    }
    const std::array<int, 2> size{width(), height()};
    if (fitted_ && (size != fitted_size_ || scale_ != fitted_scale_)) {
      fit_now();
    }
    const Projection view = projection();
    place_layers(view);
    place_tool(view);
    set_clipping(view);

    under_.begin();
    draw(lay_out_axes(frame_, view, scale_), scale_, under_);
    under_.end();
    over_.begin();
    if (executed_ && executed_->size() > 0) {
      draw_start_marker(over_, view.to_display(frame_.to_scene(start_)), scale_);
    }
    draw_annotations(over_, layout(), entries_, view, view.scale / frame_.unit, top_feed_);
    over_.end();
  }

  /// Lines in one place must not fight: each layer is a little nearer to the eye, which a parallel projection
  /// does not show.
  void place_layers(const Projection& view) {
    for (const Layer& layer : layers_) {
      const double lift = layer.height * std::max(scale_ / view.scale, 2e-6);
      const Vec3 at = frame_.to_scene(layer.origin) + lift * view.towards;
      layer.actor->SetPosition(at.x(), at.y(), at.z());
      layer.actor->SetScale(1 / frame_.unit);
      layer.actor->GetProperty()->SetLineWidth(static_cast<float>(layer.width * scale_));
      layer.actor->GetProperty()->SetPointSize(static_cast<float>(layer.width * scale_));
    }
  }

  void place_tool(const Projection& view) {
    tool_->SetVisibility(cursor_ ? 1 : 0);
    if (cursor_) {
      constexpr double before_everything = 2;
      const Vec3 at = frame_.to_scene(*cursor_) + before_everything * view.towards;
      tool_->SetPosition(at.x(), at.y(), at.z());
      tool_->SetScale(tool_pixels * scale_ / view.scale);
    }
  }

  void set_clipping(const Projection& view) {
    const double centre = eye_distance + view.focal.dot(view.towards);
    const double tool = 2 + tool_pixels * scale_ / view.scale;
    camera().SetClippingRange(centre - 1.5 - tool, centre + 1.5);
  }

  static constexpr double tool_pixels = 34;

  vtkNew<vtkRenderer> behind_;
  vtkNew<vtkRenderer> front_;
  vtkNew<vtkActor> tool_;
  Canvas under_;
  Canvas over_;
  vtkRenderWindow* window_ = nullptr;
  std::function<void()> changed_;

  std::shared_ptr<const SampledPath> programmed_;
  std::shared_ptr<const SampledPath> executed_;
  std::shared_ptr<const Trajectory> trajectory_;
  std::optional<Vec3> cursor_;
  Vec3 start_ = Vec3::Zero();
  SceneFrame frame_ = frame_around({});
  std::vector<Layer> layers_;
  LegendEntries entries_;
  double top_feed_ = 0;
  double scale_ = 1;

  bool fitted_ = true;
  std::optional<CameraPose> fitted_pose_;
  std::array<int, 2> fitted_size_{};
  double fitted_scale_ = 0;
};

PathScene::PathScene() : impl_(std::make_unique<Impl>()) {}
PathScene::~PathScene() = default;

void PathScene::attach(vtkRenderWindow& window) {
  impl_->attach(window);
}
void PathScene::on_change(std::function<void()> callback) {
  impl_->on_change(std::move(callback));
}
void PathScene::set_programmed(std::shared_ptr<const Toolpath> toolpath) {
  impl_->set_programmed(std::move(toolpath));
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
