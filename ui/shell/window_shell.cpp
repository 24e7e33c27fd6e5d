#include "ui/shell/window_shell.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>

#include <algorithm>
#include <memory>
#include <string>

#include "ui/shell/interface.h"
#include "ui/shell/settings_file.h"

namespace hazumi::ui {

namespace {

std::string g_problem;  // what GLFW said last

void TakeProblem(int, const char* text) { g_problem = text; }

Error CannotShow(const std::string& what) {
  return {ErrorCode::kFailed, "", "window",
          what + (g_problem.empty() ? "" : ": " + g_problem) +
              "; without a display use --run, --render or --bake"};
}

// GLFW, and a window with the OpenGL context that goes with it.
class Window {
 public:
  static Result<std::unique_ptr<Window>> Open() {
    glfwSetErrorCallback(TakeProblem);
    if (!glfwInit()) return CannotShow("there is no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(1280, 800, "Hazumi", nullptr, nullptr);
    if (window == nullptr) {
      glfwTerminate();
      return CannotShow("there is no OpenGL 3.3");
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return std::unique_ptr<Window>(new Window(window));
  }
  ~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* get() { return window_; }
  render::PictureSize size() const {
    render::PictureSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
  }

 private:
  explicit Window(GLFWwindow* window) : window_(window) {}
  GLFWwindow* window_;
};

// ImGui settles in a frame or two after an event: hovering, popups.
constexpr int kFramesAfterEvent = 3;

void Wait(const Editor& editor, int frames_left) {
  const double deadline = editor.NextDeadline();
  if (frames_left > 0) {
    glfwPollEvents();
  } else if (deadline < 1e6) {
    glfwWaitEventsTimeout(std::max(deadline, 1e-4));
  } else {
    glfwWaitEvents();
  }
}

std::string TitleOf(const Editor& editor) {
  const edit::Document& document = editor.session().document();
  const std::string name = document.path().empty() ? Tr("Untitled") : document.path();
  return (document.is_saved() ? "" : "* ") + name + " - Hazumi";
}

// A file dropped onto the window is opened.
void TakeDrop(GLFWwindow* window, int count, const char** paths) {
  auto* editor = static_cast<Editor*>(glfwGetWindowUserPointer(window));
  if (count > 0 && editor->dialogs.modal == Modal::kNone) {
    editor->Do("app.open", {{"path", paths[0]}});
  }
}

}  // namespace

Result<Done> RunInWindow(Editor* editor) {
  Result<std::unique_ptr<Window>> opened = Window::Open();
  if (!opened.ok()) return opened.error();
  Window& window = *opened.value();
  Result<std::unique_ptr<Interface>> interface = Interface::Create(
      [](const char* name) { return reinterpret_cast<render::GlProc>(glfwGetProcAddress(name)); },
      editor);
  if (!interface.ok()) return interface.error();
  glfwSetWindowUserPointer(window.get(), editor);
  glfwSetDropCallback(window.get(), TakeDrop);
  SettingsFile settings(SettingsPath());
  settings.Load(editor);
  editor->dialogs.shows_first_steps = !editor->settings.has_seen_first_steps;
  ImGui_ImplGlfw_InitForOpenGL(window.get(), true);
  double last = glfwGetTime();
  int frames_left = kFramesAfterEvent;
  while (!editor->wants_to_quit) {
    glfwSetWindowTitle(window.get(), TitleOf(*editor).c_str());
    const double now = glfwGetTime();
    editor->Tick(now);
    ImGui_ImplGlfw_NewFrame();
    interface.value()->Frame(window.size(), now - last);
    glfwSwapBuffers(window.get());
    last = now;
    if (!editor->dragged_splitter) settings.SaveIfChanged(editor);
    Wait(*editor, --frames_left);
    if (glfwWindowShouldClose(window.get())) {
      glfwSetWindowShouldClose(window.get(), GLFW_FALSE);
      editor->Do("app.quit");
    }
  }
  settings.SaveIfChanged(editor);
  ImGui_ImplGlfw_Shutdown();
  return Done();
}

}  // namespace hazumi::ui
