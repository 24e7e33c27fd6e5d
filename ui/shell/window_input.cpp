#include "ui/shell/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cfloat>
#include <cstring>
#include <utility>

namespace hazumi::ui {

namespace {

using Kind = InputEvent::Kind;

WindowInput* InputOf(GLFWwindow* window) {
  return static_cast<WindowInput*>(glfwGetWindowUserPointer(window));
}

const char* ReadClipboard(void* window) {
  return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
}
void WriteClipboard(void* window, const char* text) {
  glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
}

// GLFW names a key by its place on an American keyboard; shortcuts are by what is printed on it.
int PrintedKey(int key, int scancode) {
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL) return key;
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == '\0' || name[1] != '\0') return key;
  const char letter = name[0];
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  const bool is_known = std::strchr("0123456789`-=[]\\,;'./", letter) != nullptr;
  return is_known ? letter : key;
}

}  // namespace

WindowInput::WindowInput(GLFWwindow* window, InputQueue* queue, Drop drop)
    : window_(window), queue_(queue), drop_(std::move(drop)) {
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(window, OnMove);
  glfwSetCursorEnterCallback(window, OnEnter);
  glfwSetMouseButtonCallback(window, OnButton);
  glfwSetScrollCallback(window, OnWheel);
  glfwSetKeyCallback(window, OnKey);
  glfwSetCharCallback(window, OnText);
  glfwSetDropCallback(window, OnDrop);
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.GetClipboardTextFn = ReadClipboard;
  io.SetClipboardTextFn = WriteClipboard;
  io.ClipboardUserData = window;
  static_assert(kNumCursors == ImGuiMouseCursor_COUNT);
  cursors_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
}

WindowInput::~WindowInput() {
  for (GLFWcursor* cursor : cursors_) {
    if (cursor) glfwDestroyCursor(cursor);
  }
}

void WindowInput::ShowCursor() {
  const int wanted = ImGui::GetMouseCursor();
  if (wanted == shown_ || wanted < 0) return;
  shown_ = wanted;
  glfwSetCursor(window_, cursors_[wanted]);
}

// GLFW counts in the screen's units, the picture has pixels.
void WindowInput::OnMove(GLFWwindow* window, double x, double y) {
  int width = 0, height = 0, width_px = 0, height_px = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &width_px, &height_px);
  if (width <= 0 || height <= 0) return;
  InputOf(window)->queue_->Push({Kind::kMove, static_cast<float>(x * width_px / width),
                                 static_cast<float>(y * height_px / height)});
}

void WindowInput::OnEnter(GLFWwindow* window, int is_inside) {
  if (!is_inside) return InputOf(window)->queue_->Push({Kind::kMove, -FLT_MAX, -FLT_MAX});
  double x = 0.0, y = 0.0;
  glfwGetCursorPos(window, &x, &y);
  OnMove(window, x, y);
}

void WindowInput::OnButton(GLFWwindow* window, int button, int action, int) {
  InputOf(window)->queue_->Push({Kind::kButton, 0.0f, 0.0f, button, action == GLFW_PRESS});
}

void WindowInput::OnWheel(GLFWwindow* window, double x, double y) {
  InputOf(window)->queue_->Push({Kind::kWheel, static_cast<float>(x), static_cast<float>(y)});
}

// ImGui repeats keys that are held by itself.
void WindowInput::OnKey(GLFWwindow* window, int key, int scancode, int action, int) {
  if (key == GLFW_KEY_UNKNOWN || action == GLFW_REPEAT) return;
  InputOf(window)->queue_->Push(
      {Kind::kKey, 0.0f, 0.0f, PrintedKey(key, scancode), action == GLFW_PRESS});
}

void WindowInput::OnText(GLFWwindow* window, unsigned letter) {
  InputOf(window)->queue_->Push({Kind::kText, 0.0f, 0.0f, static_cast<int>(letter)});
}

void WindowInput::OnDrop(GLFWwindow* window, int count, const char** paths) {
  if (count > 0) InputOf(window)->drop_(paths[0]);
}

}  // namespace hazumi::ui
