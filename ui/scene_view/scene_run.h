#pragma once

#include <QObject>
#include <memory>

#include "ui/scene_view/scene_view.h"
#include "ui/workbench/run_comparison.h"

namespace feedscope::ui {

/// Shows one run of the list in a 3D view: as it is, or compared with another run while the colours need
/// that. The mouse then tells both.
class SceneRun : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  SceneRun(SceneView& view, RunList& runs, RunComparison& comparison, QObject* parent = nullptr);

  /// The run with this id, with the result that it has now; 0: none.
  void show(int id);
  /// What is shown; null without a result.
  const std::shared_ptr<const ShownRun>& shown() const { return shown_; }
  const std::shared_ptr<const SampledPath>& samples() const { return samples_; }
  /// A path in another view to be coloured by the same scale; may be null.
  void share_scale_with(std::shared_ptr<const SampledPath> samples);
  /// Whether the run that is compared with is the other half of this view: the title then holds for both.
  void set_halves(bool halves);
  /// The run that the colours compare with; empty where they compare with none.
  const QString& reference_name() const { return reference_name_; }

 signals:
  /// Other samples or another reference.
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
  bool compares_ = false;  ///< the colours need another run
  bool halves_ = false;
  std::shared_ptr<const ShownRun> shown_;
  std::shared_ptr<const ShownRun> reference_;
  std::shared_ptr<const SampledPath> samples_;
  std::shared_ptr<const SampledPath> scale_with_;
  QString reference_name_;
};

}  // namespace feedscope::ui
