#pragma once

#include <vtkSmartPointer.h>

#include <array>
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

/// Another run of the program, as a thin line.
struct OverlayRun {
  std::shared_ptr<const SampledPath> samples;
  Rgb colour{};
  std::string name;
};

/// How the run's paths are drawn.
struct PathLook {
  Colouring colouring = Colouring::feed;
  Rgb run{0.0, 0.447, 0.698};  ///< colour of Colouring::run
  double exaggeration = 1;     ///< factor of the deviation from the programmed path
  bool rapids = true;          ///< are drawn where they cover little of the picture
  bool all_rapids = false;     ///< where they cover much of it, too
  const SceneColours* colours = &scene_colours(Background::light);
  std::string reference;  ///< name of the run that the executed path is compared with
  std::shared_ptr<const SampledPath>
      scale_with;  ///< a path coloured by the same scale, elsewhere; may be null
};

/// Whether the view moves, and who draws it then.
enum class ViewMotion { none, on_gpu, in_software };

/// The lines of a run: rapids dashed and pale under all others, and none where they would cover the picture,
/// programmed path thin, executed path coloured, blends wide with an edge, other runs thin unless the colours
/// compare with one, a range of time underlaid. Of the executed path a stretch may be drawn in full, the rest
/// pale or not at all.
///
/// Where lines would cover the picture, they are drawn thinner; where the edges of blends would cover the
/// path, the edges are omitted. Zooming in brings both back. Paths of many points are drawn without what is
/// smaller than a pixel, and coarser while the view moves; in software with thin lines then, too: each wide
/// one takes several times as long.
class PathLayers {
 public:
  /// `below`: of a layer of the window below that of `renderer`, with the same camera: there a range and what
  /// is pale cover no path, however near they come to the eye.
  PathLayers(vtkRenderer& renderer, vtkRenderer& below)
      : renderer_(renderer), below_(below), trail_(renderer) {}

  /// Replaces what is shown; each path may be null. A path that is shown already stays as it is drawn.
  void show(std::shared_ptr<const SampledPath> programmed, std::shared_ptr<const SampledPath> executed,
            std::vector<OverlayRun> overlays, const SceneFrame& frame);
  void set_look(const PathLook& look);
  /// Underlays the executed path between two times [s].
  void set_highlight(std::optional<TimeStretch> range);
  /// What of the executed path is drawn in full; none: all of it. `only`: the box [mm] outside of which
  /// nothing else is drawn, and of the executed path nothing but the stretch; none: the rest is pale.
  void set_stretch(const std::optional<TimeStretch>& stretch, const std::optional<Bounds>& only);
  /// Behind the tool, in the colour of what is highlighted.
  PathTrail& trail() { return trail_; }
  /// Before each frame. `scale`: size of text and lines.
  void place(const SceneFrame& frame, const Projection& view, double scale, ViewMotion motion);

  /// Whether rapids are drawn in a view.
  bool shows_rapids(const Projection& view, double scale) const;
  /// What place() has made visible.
  LegendEntries entries() const;
  /// What the colours mean.
  const ColourKey& key() const { return key_; }
  const PathLook& look() const { return look_; }
  /// The executed path as drawn; null if there is none.
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
    difference,  ///< where the run differs from the one that it is compared with
    blend,
    stretch_end
  };

  /// What is drawn of one path in one manner.
  struct Layer {
    Role role = Role::cut;
    const DrawnPath* path = nullptr;
    bool discs = false;  ///< points, not lines
    Rgb colour{};        ///< of roles that have one
    /// By level of detail, made when first needed.
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
  vtkSmartPointer<vtkPlaneCollection> clipping_;  ///< around only_; null: nothing is clipped
  LegendEntries entries_;
  ColourKey key_;
  std::shared_ptr<const SampledPath> rapids_of_;
  double dashes_for_ = 0;          ///< unit of the frame that the dashes of rapids were made for [mm]
  Vec3 rapids_at_ = Vec3::Zero();  ///< origin of their dashes [mm]
  double rapid_length_ = 0;        ///< near what is cut [scene units]
  /// Of the directions of rapids with their lengths: the sum of v v^T / |v| [scene units].
  Eigen::Matrix3d rapid_spread_ = Eigen::Matrix3d::Zero();
  double cut_length_ = 0;    ///< [mm]
  double blend_length_ = 0;  ///< [mm]
  double curve_length_ = 0;  ///< of cut_length_ [mm]
  std::size_t blend_count_ = 0;
  bool rapids_seen_ = false;  ///< in the view that place() was given
};

}  // namespace feedscope::ui
