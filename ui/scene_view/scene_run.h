#pragma once

#include <QObject>
#include <memory>

#include "ui/scene_view/scene_view.h"
#include "ui/workbench/run_comparison.h"

namespace feedscope::ui {

/// Shows one run of the list in a 3D view, compared with another run if the colours need that. The hover text
/// then describes both.
class SceneRun : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  SceneRun(SceneView& view, RunList& runs, RunComparison& comparison, QObject* parent = nullptr);

  /// Shows the run with this id, with its current result; 0: none.
  void show(int id);
  /// The shown run; null without a result.
  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }
  const std::shared_ptr<const SampledPath>& samples() const { return samples_; }
  /// A path in another view that shares the colour scale; may be null.
  void share_scale_with(std::shared_ptr<const SampledPath> samples);
  /// Whether the reference run is in the other half of this view: the title then covers both.
  void set_halves(bool halves);
  /// The reference run of the colours; empty if they do not compare.
  const QString& reference_name() const { return reference_name_; }

 signals:
  /// The samples or the reference have changed.
  void changed();

 private:
  void follow();
  void follow_runs();
  QString hover_text(double time) const;
  QString compared_text(double time) const;
  void show_comparison();

  SceneView& view_;
  RunList& runs_;
  RunComparison& comparison_;
  int id_ = 0;
  bool following_ = false;
  bool compares_ = false;  ///< whether the colours need another run
  bool halves_ = false;
  std::shared_ptr<const ShownRun> shown_;
  std::shared_ptr<const ShownRun> reference_;
  std::shared_ptr<const SampledPath> samples_;
  std::shared_ptr<const SampledPath> scale_with_;
  QString reference_name_;
};

}  // namespace feedscope::ui
