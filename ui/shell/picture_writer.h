#pragma once

#include "ui/panels/dialogs/render_job.h"
#include "ui/panels/poses/state.h"

namespace hazumi::ui {

// A PictureWriter: draws without a screen, with a context of its own, on the thread that calls it.
// Errors: of making the folder, of drawing and of writing.
Result<int> WritePictures(const RenderTask& task, const std::function<void(int)>& written,
                          const std::atomic<bool>* cancel);

// See PictureKeeper::draw.
Result<std::vector<Image>> DrawPictures(const std::vector<render::Scene>& scenes, int edge_px);

}  // namespace hazumi::ui
