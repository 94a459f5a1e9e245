#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/scene/camera/projection.h"
#include "ui/scene/draw/captions.h"
#include "ui/scene/path/colouring.h"
#include "ui/scene/path/drawn_path.h"
#include "ui/scene/path/path_stretch.h"
#include "ui/scene/path/path_trail.h"

class vtkActor;
class vtkCellArray;
class vtkPlaneCollection;
class vtkPolyData;
class vtkRenderer;

namespace feedscope::ui {

/// Another run of the program, drawn as a thin line.
struct OverlayRun {
  std::shared_ptr<const SampledPath> samples;
  Rgb colour{};
  std::string name;
  double apart = HUGE_VAL;  ///< bound on its distance from the run [mm]
};

/// Appearance of the run's paths.
struct PathLook {
  Colouring colouring = Colouring::feed;
  Rgb run{0.0, 0.447, 0.698};  ///< colour of Colouring::run
  double exaggeration = 1;     ///< factor of the deviation from the programmed path
  bool rapids = true;          ///< whether to draw them where they cover little of the picture
  bool all_rapids = false;     ///< also where they cover much of it
  const SceneColours* colours = &scene_colours(Background::light);
  std::string reference;  ///< name of the run compared with the executed path
  std::shared_ptr<const SampledPath>
      scale_with;  ///< a path elsewhere with the same colour scale; may be null
};

/// Whether the view moves, and who draws it then.
enum class ViewMotion { none, on_gpu, in_software };

/// The lines of a run: rapids dashed and pale under all others, and omitted where they would cover the
/// picture; programmed path thin; executed path coloured; blends wide with an edge; other runs thin unless
/// the colours compare with one; a highlighted range of time under the path. A part of the executed path may
/// be drawn in full, the rest pale or not at all.
///
/// Where lines would cover the picture, they are thinner; where the edges of blends would cover the path,
/// they are omitted. Zooming in restores both. Paths of many points are drawn without parts smaller than a
/// pixel, and more coarsely while the view moves, in software with thin lines: a wide line takes several
/// times as long.
class PathLayers {
 public:
  /// `below`: of a layer under that of `renderer`, with the same camera: there highlighted ranges and pale
  /// parts never cover the path, however near they are to the eye.
  PathLayers(vtkRenderer& renderer, vtkRenderer& below)
      : renderer_(renderer), below_(below), trail_(renderer) {}

  /// Replaces the shown paths; each may be null. A path already shown is not drawn again.
  void show(std::shared_ptr<const SampledPath> programmed, std::shared_ptr<const SampledPath> executed,
            std::vector<OverlayRun> overlays, const SceneFrame& frame);
  void set_look(const PathLook& look);
  /// Highlights the executed path between two times [s].
  void set_highlight(std::optional<TimeStretch> range);
  /// The part of the executed path drawn in full; none: all. `only`: box [mm] to which everything is clipped;
  /// of the executed path only the part is then drawn; none: the rest is pale.
  void set_stretch(const std::optional<TimeStretch>& stretch, const std::optional<Bounds>& only);
  /// The trail of the tool, in the colour of highlights.
  PathTrail& trail() { return trail_; }
  /// Before each frame. `scale`: size of text and lines.
  void place(const SceneFrame& frame, const Projection& view, double scale, ViewMotion motion);

  /// Whether rapids are drawn in a view.
  bool shows_rapids(const Projection& view, double scale) const;
  /// Legend entries for the lines that the last place() made visible.
  LegendEntries entries() const;
  /// Meaning of the colours.
  const ColourKey& key() const { return key_; }
  const PathLook& look() const { return look_; }
  /// The drawn executed path; null if there is none.
  const DrawnPath* executed() const { return executed_.get(); }

 private:
  enum class Role {
    rapid,
    programmed,
    range,
    rest,
    curve_edge,
    blend_edge,
    overlay,
    cut,
    difference,  ///< where the run differs from its reference
    blend,
    stretch_end
  };

  /// Drawing of one path in one style.
  struct Layer {
    Role role = Role::cut;
    const DrawnPath* path = nullptr;
    bool discs = false;  ///< points, not lines
    Rgb colour{};        ///< for roles with a fixed colour
    /// By level of detail, created on demand.
    std::vector<vtkSmartPointer<vtkActor>> actors;
  };
  struct Style {
    double width = 1;
    double height = 0;
  };

  template <class Wanted>
  void remove(Wanted wanted);
  void add(Role role, const DrawnPath* path, bool discs = false, const Rgb& colour = {});
  void show_rapids(const std::shared_ptr<const SampledPath>& path, const SceneFrame& frame);
  void measure_rapids(const SampledPath& path, const SceneFrame& frame);
  /// Whether any part of the rapids is within the window.
  bool are_rapids_within(const SceneFrame& frame, const Projection& view) const;
  void show_programmed(std::shared_ptr<const SampledPath> programmed);
  void show_overlays(std::vector<OverlayRun> overlays);
  void show_executed(std::shared_ptr<const SampledPath> executed);
  void update_parts(const SceneFrame& frame, const Projection& view, bool moving);
  vtkSmartPointer<vtkActor> make_actor(const Layer& layer, const PathPart& part) const;
  vtkSmartPointer<vtkCellArray> cells_of(const Layer& layer, const PathPart& part) const;
  vtkSmartPointer<vtkCellArray> highlighted(const PathPart& part) const;
  vtkSmartPointer<vtkPolyData> lines_of(const Layer& layer, const PathPart& part) const;
  void redraw(const std::vector<Role>& roles);
  void place_clipping(const SceneFrame& frame, const Projection& view);
  void colour_executed();
  void colour_layers();
  Rgb colour_of(const Layer& layer) const;
  double covered_by_edges(double millimetre, double scale) const;
  Style style_of(Role role, double thinner) const;
  bool differs(std::size_t point) const;
  bool overlays_shown() const { return !needs_reference(look_.colouring); }

  vtkRenderer& renderer_of(const Layer& layer) const {
    const bool below = layer.role == Role::range || layer.role == Role::rest || layer.role == Role::rapid;
    return below ? below_ : renderer_;
  }

  vtkRenderer& renderer_;
  vtkRenderer& below_;
  PathTrail trail_;
  PathLook look_;
  std::unique_ptr<DrawnPath> programmed_;
  std::unique_ptr<DrawnPath> executed_;
  std::vector<std::unique_ptr<DrawnPath>> overlays_;
  std::vector<Layer> layers_;
  std::optional<TimeStretch> range_;
  std::optional<TimeStretch> stretch_;
  std::optional<Bounds> only_;                    ///< [mm]
  vtkSmartPointer<vtkPlaneCollection> clipping_;  ///< around only_; null: no clipping
  LegendEntries entries_;
  ColourKey key_;
  std::shared_ptr<const SampledPath> rapids_of_;
  double dashes_for_ = 0;          ///< frame unit for which the dashes of rapids were made [mm]
  Vec3 rapids_at_ = Vec3::Zero();  ///< origin of their dashes [mm]
  double rapid_length_ = 0;        ///< near the cut path [scene units]
  /// Directions of rapids weighted by length: the sum of v v^T / |v| [scene units].
  Eigen::Matrix3d rapid_spread_ = Eigen::Matrix3d::Zero();
  double cut_length_ = 0;    ///< [mm]
  double blend_length_ = 0;  ///< [mm]
  double curve_length_ = 0;  ///< of cut_length_ [mm]
  std::size_t blend_count_ = 0;
  bool rapids_in_sight_ = false;  ///< in the last place()
};

}  // namespace feedscope::ui
