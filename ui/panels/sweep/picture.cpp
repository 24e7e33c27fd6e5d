#include <filesystem>

#include "engine/base/text.h"
#include "engine/picture/decode_pictures.h"
#include "engine/project/json/text_file.h"
#include "ui/panels/sweep/actions.h"

namespace hazumi::ui {

namespace {

Result<Image> ReadPicture(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  const std::vector<std::uint8_t> bytes = BytesOf(text.value());
  const std::span<const std::uint8_t> files[] = {bytes};
  return std::move(DecodePictures(files).front());
}

}  // namespace

unsigned PictureOfCell(Editor* editor) {
  SweepState& state = editor->sweep;
  if (state.pictured == state.cell) return state.texture;
  DropPicture(editor);
  state.pictured = state.cell;
  if (!state.cell) return 0;
  const std::string path = state.swept->PictureOf(*state.cell);
  if (path.empty() || !editor->pictures.add) return 0;
  const Result<Image> image = ReadPicture(path);
  if (!image.ok()) {
    editor->Say(image.error().ToString(), true);
    return 0;
  }
  return state.texture = editor->pictures.add(image.value());
}

double AspectOfPictures(const SweptFolder& swept) {
  for (size_t cell = 0; cell < swept.rows.size(); ++cell) {
    const std::string path = swept.PictureOf(cell);
    std::error_code unknown;
    if (path.empty() || !std::filesystem::exists(path, unknown)) continue;
    const Result<Image> image = ReadPicture(path);
    return image.ok() ? static_cast<double>(image.value().width) / image.value().height : 0.0;
  }
  return 0.0;
}

void DropPicture(Editor* editor) {
  SweepState& state = editor->sweep;
  if (state.texture != 0 && editor->pictures.free) editor->pictures.free(state.texture);
  state.texture = 0;
  state.pictured.reset();
}

}  // namespace hazumi::ui
