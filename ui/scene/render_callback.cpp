#include "ui/scene/render_callback.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace feedscope::ui {

void call_before(vtkRenderer& renderer, void* data, void (*call)(vtkObject*, unsigned long, void*, void*)) {
  const vtkNew<vtkCallbackCommand> before;
  before->SetClientData(data);
  before->SetCallback(call);
  renderer.AddObserver(vtkCommand::StartEvent, before);
}

}  // namespace feedscope::ui
