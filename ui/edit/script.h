#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ui/edit/session.h"

namespace hazumi::edit {

// A script is what was done, in order: a JSON list of objects such as
//   {"op": "key.set", "curve": "r_knee", "frame": 5, "value": 40}
// each naming an operator and its parameters.

// Does what a script says, on a session. Stops at the first thing that cannot be done, with its
// number and line of the list in the error's place. `done` is told of each step; may be empty.
Result<Done> RunScript(std::string_view text, const std::string& file_name, Session* session,
                       const std::function<void(const std::string& id)>& done = {});

// Writes down what a session does, as long as both are there.
class ScriptRecorder {
 public:
  explicit ScriptRecorder(Session* session);
  ScriptRecorder(const ScriptRecorder&) = delete;
  ScriptRecorder& operator=(const ScriptRecorder&) = delete;
  // The script so far, a step a line.
  std::string text() const;

 private:
  std::vector<std::string> steps_;
  std::shared_ptr<const SessionObserver> observer_;
};

}  // namespace hazumi::edit
