#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ui/edit/session/session.h"

namespace hazumi::edit {

// A script is what was done, in order: a JSON list of objects such as
//   {"op": "key.set", "curve": "r_knee", "frame": 5, "value": 40}
// each naming an operator and its parameters.

// Does a step: Session::Run, or more than that where there is more than a session.
using ScriptRunner = std::function<Result<Done>(const std::string& id, const Json& parameters)>;

// Does what a script says. Stops at the first thing that cannot be done, with its number in the
// list in the error's place.
Result<Done> RunScript(std::string_view text, const std::string& file_name,
                       const ScriptRunner& run);

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
