#include "ui/shell/offscreen_shell.h"

#include <utility>

#include "engine/base/utf8.h"
#include "render/image/png.h"

namespace hazumi::ui {

using Kind = InputEvent::Kind;

Result<std::unique_ptr<OffscreenShell>> OffscreenShell::Create(Editor* editor,
                                                               render::PictureSize size) {
  Result<render::OsmesaContext> context = render::OsmesaContext::Create();
  if (!context.ok()) return context.error();
  std::unique_ptr<OffscreenShell> shell(
      new OffscreenShell(editor, size, std::move(context).value()));
  if (!shell->context_.MakeCurrent(shell->picture_.rgba.data(), size.width, size.height)) {
    return Error{ErrorCode::kFailed, "", "OSMesa", "Mesa refuses a picture of this size"};
  }
  auto interface = Interface::Create(shell->context_.loader(), editor);
  if (!interface.ok()) return interface.error();
  shell->interface_ = std::move(interface).value();
  return shell;
}

OffscreenShell::OffscreenShell(Editor* editor, render::PictureSize size,
                               render::OsmesaContext context)
    : editor_(editor), picture_(size.width, size.height), context_(std::move(context)) {}

OffscreenShell::~OffscreenShell() {
  context_.MakeCurrent(picture_.rgba.data(), picture_.width, picture_.height);
  interface_.reset();
}

void OffscreenShell::MoveMouse(float x, float y) { interface_->input().Push({Kind::kMove, x, y}); }
void OffscreenShell::PressButton(int button, bool is_down) {
  interface_->input().Push({Kind::kButton, 0.0f, 0.0f, button, is_down});
}
void OffscreenShell::TurnWheel(float notches) {
  interface_->input().Push({Kind::kWheel, 0.0f, notches});
}
void OffscreenShell::PressKey(int key, bool is_down) {
  interface_->input().Push({Kind::kKey, 0.0f, 0.0f, key, is_down});
}
void OffscreenShell::Type(const std::string& utf8) {
  for (const char32_t letter : DecodeUtf8(utf8)) {
    interface_->input().Push({Kind::kText, 0.0f, 0.0f, static_cast<int>(letter)});
  }
}

void OffscreenShell::Frame(double seconds) {
  now_ += seconds;
  context_.MakeCurrent(picture_.rgba.data(), picture_.width, picture_.height);
  editor_->Tick(now_);
  interface_->Frame({picture_.width, picture_.height}, seconds);
  interface_->Finish();
}

Result<Done> OffscreenShell::Capture(const std::string& path) {
  constexpr int kSettle =
      3;  // windows of ImGui find their size in one frame and their place in two
  for (int i = 0; i < kSettle; ++i) Frame();
  return render::WritePng(path, picture_, {});
}

}  // namespace hazumi::ui
