// The window: splitters, shortcuts and tools, and which panel is where.

#include <imgui_internal.h>

#include "ui/panels/commands/actions.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

Place PlaceOf(const WindowLayout& layout, Point mouse) {
  if (layout.viewport.Contains(mouse)) return Place::kViewport;
  if (layout.sheet.Contains(mouse)) return Place::kSheet;
  return Place::kAnywhere;
}

void FeedTool(Editor* editor) {
  const ImGuiIO& io = ImGui::GetIO();
  ToolInput input;
  input.mouse = editor->mouse;
  input.is_pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  input.is_held = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  input.precise = io.KeyShift;
  input.snap = io.KeyCtrl;
  input.confirm = input.is_pressed;
  input.cancel = ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  for (const Chord& chord : PressedKeys(true)) {
    input.confirm |= chord.key == kEnter || chord.key == kPadEnter;
    input.cancel |= chord.key == kEscape;
    input.keys.push_back(chord);
  }
  editor->UpdateTool(input);
}

// Keys that repeat while they are held: those that step through time.
bool Repeats(const Shortcut& shortcut) { return std::string(shortcut.id) == "time.step"; }

void RunShortcuts(Editor* editor, Place place) {
  // ImGui still wants text in the frame after Enter, when nothing takes it any more.
  if (ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive()) return;
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  for (const Chord& chord : PressedKeys(true)) {
    const Shortcut* shortcut = FindShortcut(chord, place);
    if (!shortcut) continue;
    if (!ImGui::IsKeyPressed(chord.key, false) && !Repeats(*shortcut)) continue;
    editor->Do(shortcut->id, shortcut->parameters);
  }
}

bool IsDialog(const ImGuiPopupData& popup) {
  return popup.Window && (popup.Window->Flags & ImGuiWindowFlags_Modal) != 0;
}

// Esc closes menus and choices, which have no focus by keys in ImGui; dialogs answer it themselves.
void CloseMenusByKey() {
  const ImVector<ImGuiPopupData>& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  const bool types = ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
  if (types || !ImGui::IsKeyPressed(kEscape, false)) return;
  int stay = popups.Size;
  while (stay > 0 && !IsDialog(popups[stay - 1])) --stay;
  if (stay < popups.Size) ImGui::ClosePopupToLevel(stay, true);
}

void DragSplitters(Editor* editor, const Rect& window, const WindowLayout& layout) {
  std::optional<Splitter>& dragged = editor->dragged_splitter;
  const double scale = editor->settings.scale;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const bool is_covered =
      editor->has_tool() ||
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (is_covered && !dragged) return;
  const std::optional<Splitter> hovered = dragged ? dragged : SplitterAt(layout, mouse, scale);
  if (hovered) {
    ImGui::SetMouseCursor(*hovered == Splitter::kSide ? ImGuiMouseCursor_ResizeEW
                                                      : ImGuiMouseCursor_ResizeNS);
  }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) dragged = hovered;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) dragged.reset();
  if (!dragged) return;
  editor->settings.shares = DragSplitter(window, editor->settings.shares, *dragged, mouse, scale);
}

}  // namespace

void DrawWindow(Editor* editor, float width, float height) {
  const Rect window = LeastWindow({0.0f, 0.0f, width, height}, editor->settings.scale);
  SetLanguage(editor->settings.language);
  SetKeymap(editor->settings.keymap);
  const WindowLayout layout = LayOutWindow(window, editor->settings.shares, editor->settings.scale);
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  if (ImGui::IsMousePosValid()) editor->mouse = mouse;
  editor->sheet.is_quiet = false;
  editor->viewport.rect = layout.viewport;  // tools ask for it, in their first frame too
  CloseMenusByKey();
  if (editor->has_tool()) {
    FeedTool(editor);
  } else {
    RunShortcuts(editor, PlaceOf(layout, mouse));
  }
  DragSplitters(editor, window, layout);
  DrawMenuBar(editor, layout.menu);
  DrawViewport(editor, layout.viewport);
  DrawTimeline(editor, layout.timeline);
  if (editor->sheet.kind == SheetKind::kGraph) {
    DrawGraph(editor, layout.sheet);
  } else {
    DrawDopeSheet(editor, layout.sheet);
  }
  DrawOutliner(editor, layout.outliner);
  DrawProperties(editor, layout.properties);
  DrawStatusBar(editor, layout.status);
  DrawDialogs(editor, window);
  DrawRecovery(editor);
}

}  // namespace hazumi::ui
