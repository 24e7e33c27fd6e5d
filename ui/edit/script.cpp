#include "ui/edit/script.h"

namespace hazumi::edit {

Result<Done> RunScript(std::string_view text, const std::string& file_name,
                       const ScriptRunner& run) {
  const Json steps = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!steps.is_array()) {
    return Error{ErrorCode::kSyntax, file_name, "", "must be a JSON list of steps"};
  }
  for (size_t i = 0; i < steps.size(); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    Json parameters = steps[i];
    if (!parameters.is_object() || !parameters.contains("op") || !parameters["op"].is_string()) {
      return Error{ErrorCode::kSchema, file_name, place,
                   "must be an object with \"op\", the id of an operator"};
    }
    const std::string id = parameters["op"].get<std::string>();
    parameters.erase("op");
    const Result<Done> result = run(id, parameters);
    if (!result.ok()) {
      const Error& error = result.error();
      std::string where = place;  // in the script, then in a file that the operator read
      for (const std::string& part : {error.file, error.place}) {
        if (!part.empty()) where += ": " + part;
      }
      return Error{error.code, file_name, where, error.message};
    }
  }
  return Done();
}

ScriptRecorder::ScriptRecorder(Session* session) {
  const auto note = [this](const std::string& id, const Json& parameters) {
    Json step = {{"op", id}};
    step.update(parameters);
    steps_.push_back(step.dump());
  };
  observer_ = session->Observe({.before = {}, .after = note});
}

std::string ScriptRecorder::text() const {
  std::string text = "[\n";
  for (size_t i = 0; i < steps_.size(); ++i) {
    text += "  " + steps_[i] + (i + 1 < steps_.size() ? ",\n" : "\n");
  }
  return text + "]\n";
}

}  // namespace hazumi::edit
