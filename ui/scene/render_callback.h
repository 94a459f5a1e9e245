#pragma once

class vtkObject;
class vtkRenderer;

namespace feedscope::ui {

/// Calls `call` with `data` before each frame of a renderer; both must outlive it.
void call_before(vtkRenderer& renderer, void* data, void (*call)(vtkObject*, unsigned long, void*, void*));

}  // namespace feedscope::ui
