#pragma once

#include <functional>
#include <string>

#include "ui/shell/input_queue.h"

struct GLFWwindow;
struct GLFWcursor;

namespace hazumi::ui {

// Mouse, keyboard, clipboard and cursor of a GLFW window, for the ImGui context that is current.
// It has the window's user pointer.
class WindowInput {
 public:
  using Drop = std::function<void(const std::string& path)>;  // a file was dropped on the window

  WindowInput(GLFWwindow* window, InputQueue* queue, Drop drop);
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  // Gives the mouse the shape that ImGui asks for.
  void ShowCursor();

 private:
  static void OnMove(GLFWwindow* window, double x, double y);
  static void OnEnter(GLFWwindow* window, int is_inside);
  static void OnButton(GLFWwindow* window, int button, int action, int modifiers);
  static void OnWheel(GLFWwindow* window, double x, double y);
  static void OnKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void OnText(GLFWwindow* window, unsigned letter);
  static void OnDrop(GLFWwindow* window, int count, const char** paths);

  static constexpr int kNumCursors = 9;  // of ImGui

  GLFWwindow* window_;
  InputQueue* queue_;
  Drop drop_;
  GLFWcursor* cursors_[kNumCursors] = {};  // null: the arrow
  int shown_ = 0;
};

}  // namespace hazumi::ui
