#include "ui/shell/interface.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"
#include "ui/shell/fonts.h"
#include "ui/shell/picture_writer.h"

namespace hazumi::ui {

namespace {

static_assert(sizeof(ImDrawVert) == sizeof(render::InterfaceVertex));
static_assert(sizeof(ImDrawIdx) == sizeof(std::uint16_t));

constexpr double kTextSize = 14.0;  // at scale 1 [px]

// Keys are numbered as GLFW numbers them, with a window and without.
void MapKeys(ImGuiIO* io) {
  const std::pair<int, int> keys[] = {{ImGuiKey_Tab, kTab},
                                      {ImGuiKey_LeftArrow, kLeft},
                                      {ImGuiKey_RightArrow, kRight},
                                      {ImGuiKey_UpArrow, kUp},
                                      {ImGuiKey_DownArrow, kDown},
                                      {ImGuiKey_PageUp, kPageUp},
                                      {ImGuiKey_PageDown, kPageDown},
                                      {ImGuiKey_Home, kHome},
                                      {ImGuiKey_End, kEnd},
                                      {ImGuiKey_Delete, kDelete},
                                      {ImGuiKey_Backspace, kBackspace},
                                      {ImGuiKey_Space, kSpace},
                                      {ImGuiKey_Enter, kEnter},
                                      {ImGuiKey_Escape, kEscape},
                                      {ImGuiKey_KeyPadEnter, kPadEnter},
                                      {ImGuiKey_A, 'A'},
                                      {ImGuiKey_C, 'C'},
                                      {ImGuiKey_V, 'V'},
                                      {ImGuiKey_X, 'X'},
                                      {ImGuiKey_Y, 'Y'},
                                      {ImGuiKey_Z, 'Z'}};
  for (const auto& [name, key] : keys) io->KeyMap[name] = key;
}

unsigned TextureOf(ImTextureID id) {
  return static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(id));
}

render::InterfaceLayer LayerOf(const ImDrawList& list) {
  render::InterfaceLayer layer;
  layer.vertices = {reinterpret_cast<const render::InterfaceVertex*>(list.VtxBuffer.Data),
                    static_cast<size_t>(list.VtxBuffer.Size)};
  layer.indices = {list.IdxBuffer.Data, static_cast<size_t>(list.IdxBuffer.Size)};
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    layer.parts.push_back({clip.x, clip.y, clip.z, clip.w, TextureOf(command.GetTexID()),
                           command.IdxOffset, command.ElemCount, command.VtxOffset});
  }
  return layer;
}

// Every sign that the interface may show: the catalogue's and the project's.
std::string TextsToShow(const Editor& editor) {
  std::string texts = "日本語English";
  const auto add = [&](const std::string& text) { texts += text; };
  for (const std::string_view key : CatalogueKeys()) texts += Tr(std::string(key).c_str());
  const Project& project = editor.session().project();
  add(project.name);
  add(editor.session().document().path());
  add(editor.glyphs());
  for (const std::string& file : editor.settings.recent_files) add(file);
  for (const ProjectRegion& region : project.regions) add(region.name);
  for (const ProjectSceneObject& object : project.scene.objects) add(object.name);
  return texts;
}

}  // namespace

Result<std::unique_ptr<Interface>> Interface::Create(render::GlProcLoader loader, Editor* editor) {
  Result<render::InterfacePainter> painter = render::InterfacePainter::Create(loader);
  if (!painter.ok()) return painter.error();
  Result<render::SceneTexture> with = render::SceneTexture::Create(loader, {4, true, 1024});
  if (!with.ok()) return with.error();
  Result<render::SceneTexture> without = render::SceneTexture::Create(loader, {4, false, 1});
  if (!without.ok()) return without.error();
  return std::unique_ptr<Interface>(new Interface(
      editor, std::move(painter).value(), std::move(with).value(), std::move(without).value()));
}

Interface::Interface(Editor* editor, render::InterfacePainter painter,
                     render::SceneTexture with_shadow, render::SceneTexture without)
    : editor_(editor),
      context_(ImGui::CreateContext()),
      painter_(std::make_unique<render::InterfacePainter>(std::move(painter))),
      with_shadow_(std::move(with_shadow)),
      without_shadow_(std::move(without)) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  MapKeys(&io);
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ConfigDragClickToInputText = true;  // a click on a number edits it, as in Blender
  editor_->viewport.shown.reset();       // was in a texture of another context
  editor_->paint_scene = [this](const render::Scene& scene, render::PictureSize size, bool shadow) {
    return (shadow ? with_shadow_ : without_shadow_).Draw(scene, size);
  };
  editor_->pictures = {
      DrawPictures,
      [this](const Image& picture) {
        return painter_->AddTexture(picture.rgba.data(), {picture.width, picture.height});
      },
      [this](unsigned texture) { painter_->FreeTexture(texture); }};
  editor_->write_pictures = WritePictures;
}

Interface::~Interface() {
  editor_->paint_scene = nullptr;
  editor_->poses.thumbnails.reset();  // their textures are of this context
  editor_->pictures = {};
  ImGui::DestroyContext(context_);
}

// Colours, measures and fonts follow the settings.
void Interface::Restyle() {
  const Settings& settings = editor_->settings;
  const bool same_fonts = is_styled_ && scale_ == settings.scale &&
                          language_ == settings.language &&
                          num_glyph_bytes_ == editor_->glyphs().size();
  if (same_fonts && is_dark_ == settings.dark) return;
  is_styled_ = true;
  is_dark_ = settings.dark;
  scale_ = settings.scale;
  language_ = settings.language;
  num_glyph_bytes_ = editor_->glyphs().size();
  SetLanguage(language_);
  ApplyTheme(editor_->theme(), scale_);
  if (!same_fonts) LoadFonts();
}

void Interface::LoadFonts() {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  if (!BuildFonts(static_cast<float>(std::round(kTextSize * scale_)), TextsToShow(*editor_),
                  atlas)) {
    editor_->Say("fonts are missing: install fonts-dejavu-core and fonts-noto-cjk", true);
  }
  unsigned char* rgba = nullptr;
  int width = 0, height = 0;
  atlas->GetTexDataAsRGBA32(&rgba, &width, &height);
  if (font_texture_ != 0) painter_->FreeTexture(font_texture_);
  font_texture_ = painter_->AddTexture(rgba, {width, height});
  atlas->SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(font_texture_)));
}

void Interface::Frame(render::PictureSize size, double seconds) {
  ImGui::SetCurrentContext(context_);
  Restyle();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
  io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
  // ImGui still wants text in the frame after Enter, when nothing takes it any more.
  input_.Feed(io.WantTextInput && ImGui::IsAnyItemActive(), &io);
  ImGui::NewFrame();
  DrawWindow(editor_, io.DisplaySize.x, io.DisplaySize.y);
  ImGui::Render();
  Paint(size);
}

void Interface::Paint(render::PictureSize size) {
  const ImDrawData& data = *ImGui::GetDrawData();
  std::vector<render::InterfaceLayer> layers;
  layers.reserve(data.CmdListsCount);
  for (int i = 0; i < data.CmdListsCount; ++i) layers.push_back(LayerOf(*data.CmdLists[i]));
  const long pictures = editor_->viewport.pictures_drawn;
  const bool has_new_picture = std::exchange(pictures_painted_, pictures) != pictures;
  painter_->Draw(layers, size, editor_->theme().window, has_new_picture);
}

}  // namespace hazumi::ui
