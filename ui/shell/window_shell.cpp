#include "ui/shell/window_shell.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <utility>

#include "ui/panels/window/layout.h"
#include "ui/panels/window/panels.h"
#include "ui/shell/crash_safety.h"
#include "ui/shell/interface.h"
#include "ui/shell/settings_file.h"
#include "ui/shell/sound_player.h"
#include "ui/shell/window_input.h"

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
      const Error error = CannotShow("there is no OpenGL 3.3");
      glfwTerminate();
      return error;
    }
    glfwSetWindowSizeLimits(window, static_cast<int>(kLeastWidth), static_cast<int>(kLeastHeight),
                            GLFW_DONT_CARE, GLFW_DONT_CARE);
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
  // Only when it changes: the window is told of every change.
  void SetTitle(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
  }

 private:
  explicit Window(GLFWwindow* window) : window_(window) {}
  GLFWwindow* window_;
  std::string title_;
};

// ImGui settles in a frame or two after an event: hovering, popups. The next event goes before.
constexpr int kFramesAfterEvent = 3;
constexpr double kSettlePause = 0.02;  // [s]
constexpr double kSettle = 0.1;        // [s]
constexpr double kCursorBlink = 0.4;   // [s]
constexpr double kKeyRepeat = 0.05;    // as ImGui repeats [s]

bool IsKeyHeld() {
  const auto& keys = ImGui::GetIO().KeysDown;
  return std::any_of(std::begin(keys) + kSpace, std::begin(keys) + kLeftShift,
                     [](bool is_down) { return is_down; });
}

std::string TitleOf(const Editor& editor) {
  const edit::Document& document = editor.session().document();
  const std::string name = document.path().empty() ? Tr("Untitled") : document.path();
  return (document.is_saved() ? "" : "* ") + name + " - Hazumi";
}

// A file dropped onto the window is opened, unless a dialog waits for an answer.
void TakeDrop(const std::string& path, Editor* editor) {
  if (editor->dialogs.modal != Modal::kNone) return;
  editor->Take(nullptr);
  editor->Do("app.open", {{"path", path}});
}

// Draws frames as long as there is a reason to, and sleeps in between.
class Loop {
 public:
  Loop(Window* window, Interface* interface, Editor* editor, const WindowOptions& options)
      : window_(*window),
        interface_(*interface),
        editor_(*editor),
        settings_(SettingsPath()),
        safety_(editor, options.state_folder),
        input_(window->get(), &interface->input(),
               [editor](const std::string& path) { TakeDrop(path, editor); }),
        options_(options) {
    constexpr double kPatience = 0.1;  // [s]
    settings_.Load(editor);
    editor->poses.library.set_path(PosesPath());
    editor->session().set_patience(kPatience);
    editor_.dialogs.shows_first_steps = !editor_.settings.has_seen_first_steps;
  }

  void Run() {
    safety_.LookForCrash();
    while (!editor_.wants_to_quit) {
      DrawFrame();
      Wait();
      if (!glfwWindowShouldClose(window_.get())) continue;
      glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
      editor_.Do("app.quit");
    }
    settings_.SaveIfChanged(&editor_);
    safety_.Close();
  }

 private:
  void DrawFrame() {
    const double now = glfwGetTime();
    editor_.Tick(now);
    interface_.Frame(window_.size(), now - last_frame_);
    // What a dialog leaves behind that closes by itself is gone some pictures later.
    const Modal modal = editor_.dialogs.modal;
    if (std::exchange(drawn_modal_, modal) != modal) frames_left_ = kFramesAfterEvent;
    sound_.Follow(&editor_);
    input_.ShowCursor();
    glfwSwapBuffers(window_.get());
    if (options_.trace != nullptr) Trace();
    event_time_ = -1.0;
    last_frame_ = now;
    safety_.Tick();
    if (!editor_.dragged_splitter) settings_.SaveIfChanged(&editor_);
    window_.SetTitle(TitleOf(editor_));
  }

  // Tells of the picture that was drawn last.
  void Trace() {
    interface_.Finish();
    const double now = glfwGetTime();
    const edit::Session& session = editor_.session();
    const std::pair document(session.document_number(), session.document().revision());
    const bool is_baking = session.bake() != nullptr && session.bake()->is_busy();
    const bool has_changed = std::exchange(traced_document_, document) != document;
    if (event_time_ >= 0.0) {
      options_.trace->AddEvent(
          {now - event_time_, has_changed, is_baking, ImGui::GetIO().WantTextInput});
    }
    TraceFrame(now);
  }

  void TraceFrame(double now) {
    const Playback& playback = editor_.playback;
    const bool is_same = std::exchange(traced_frames_, playback.frames()) == playback.frames();
    const int passed = playback.dropped() - std::exchange(traced_passed_, playback.dropped());
    if (!playback.is_on() || is_same) return;
    options_.trace->AddFrame({now - playback.due(), playback.frame_seconds(), std::max(0, passed)});
  }

  double Deadline() const {
    double deadline = std::min(editor_.NextDeadline(), safety_.NextDeadline());
    if (ImGui::GetIO().WantTextInput) deadline = std::min(deadline, kCursorBlink);
    if (IsKeyHeld()) deadline = std::min(deadline, kKeyRepeat);
    // A tooltip is drawn a frame after it is asked for.
    const double tooltip = SecondsToTooltip();
    if (tooltip > -kSettle) deadline = std::min(deadline, std::max(0.0, tooltip));
    return deadline;
  }

  // An event that is there at once came while the picture was drawn: its time is taken to be when
  // that was begun.
  void Wait() {
    constexpr double kLongest = 3600.0, kAtOnce = 5e-4;  // [s]
    double pause = std::clamp(Deadline(), 1e-4, kLongest);
    if (frames_left_ > 0) pause = std::min(pause, kSettlePause);
    const bool has_input = !interface_.input().is_empty();
    const double start = glfwGetTime();
    has_input ? glfwPollEvents() : glfwWaitEventsTimeout(pause);
    const double waited = glfwGetTime() - start;
    if (has_input || waited < pause) return Settle(waited < kAtOnce ? last_frame_ : start + waited);
    if (frames_left_ > 0) --frames_left_;
  }

  // Only what the user does is traced.
  void Settle(double event_time) {
    if (!interface_.input().is_empty()) event_time_ = event_time;
    frames_left_ = editor_.playback.is_on() ? 0 : kFramesAfterEvent - 1;
  }

  Window& window_;
  Interface& interface_;
  Editor& editor_;
  SettingsFile settings_;
  CrashSafety safety_;
  SoundPlayer sound_;
  WindowInput input_;
  const WindowOptions& options_;
  double last_frame_ = 0.0, event_time_ = -1.0;
  int frames_left_ = kFramesAfterEvent;
  Modal drawn_modal_ = Modal::kNone;
  std::pair<long, long> traced_document_;      // its number and revision
  int traced_frames_ = 0, traced_passed_ = 0;  // of playback
};

}  // namespace

Result<Done> RunInWindow(Editor* editor, const WindowOptions& options) {
  Result<std::unique_ptr<Window>> window = Window::Open();
  if (!window.ok()) return window.error();
  Result<std::unique_ptr<Interface>> interface = Interface::Create(
      [](const char* name) { return reinterpret_cast<render::GlProc>(glfwGetProcAddress(name)); },
      editor);
  if (!interface.ok()) return interface.error();
  Loop(window.value().get(), interface.value().get(), editor, options).Run();
  return Done();
}

}  // namespace hazumi::ui
