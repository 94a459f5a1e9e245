#pragma once

#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "ui/scene/annotations.h"
#include "ui/scene/colour_map.h"
#include "ui/scene/projection.h"
#include "ui/scene/sampled_path.h"

class vtkActor;
class vtkLookupTable;
class vtkPolyData;
class vtkRenderer;

namespace feedscope::ui {

/// The lines of a run: rapids dashed, programmed path thin, executed path coloured by feed, blends wide with
/// a dark edge.
///
/// Where lines would cover the picture they get thinner, and blends lose their edge, until one zooms in.
/// Paths of many points are drawn from copies that leave out what is smaller than a pixel.
class PathLayers {
 public:
  explicit PathLayers(vtkRenderer& renderer) : renderer_(renderer) {}

  /// Replaces what is shown; each path may be null.
  void show(std::shared_ptr<const SampledPath> programmed, std::shared_ptr<const SampledPath> executed,
            const SceneFrame& frame);
  /// Before each frame. `scale`: size of text and lines.
  void place(const SceneFrame& frame, const Projection& view, double scale);

  /// What place() has made visible.
  const LegendEntries& entries() const { return entries_; }
  /// Feed of the brightest colour [mm/s]; 0 if nothing is coloured.
  double top_feed() const { return top_feed_; }

 private:
  enum class Role { rapid, programmed, cut, blend, blend_edge };

  struct Layer {
    vtkSmartPointer<vtkActor> actor;
    Role role;
    bool discs = false;     ///< points, not lines
    std::size_t level = 0;  ///< of detail; 0 is the whole path
  };
  /// A path at one level of detail.
  struct Detail {
    std::shared_ptr<const SampledPath> path;
    double spacing = 0;  ///< points closer than this are left out [mm]
  };

  void clear();
  void add(vtkPolyData& lines, vtkSmartPointer<vtkActor> actor, Role role, bool discs, std::size_t level,
           const SceneFrame& frame, const Vec3& origin);
  void add_rapids(const SampledPath& path, const SceneFrame& frame);
  void add_executed(std::shared_ptr<const SampledPath> executed, const SceneFrame& frame);
  double crowding(const SceneFrame& frame, const Projection& view, double drawn) const;

  vtkRenderer& renderer_;
  std::shared_ptr<const SampledPath> programmed_;
  std::vector<Detail> details_;  ///< of the executed path, finest first
  std::vector<Layer> layers_;
  std::vector<Vec3> places_;  ///< of the layers, in the scene
  LegendEntries entries_;
  double top_feed_ = 0;
  double rapid_length_ = 0;  ///< [mm]
  double cut_length_ = 0;    ///< [mm]
  double blend_length_ = 0;  ///< [mm]
};

}  // namespace feedscope::ui
