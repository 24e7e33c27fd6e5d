#include "ui/edit/recovery/state_folder.h"

namespace hazumi::edit {

// A relative path counts as none [XDG Base Directory Specification].
Result<std::string> StateFolder(const std::function<const char*(const char* name)>& variable) {
  const auto folder_in = [&](const char* name) {
    const char* value = variable(name);
    return value && value[0] == '/' ? std::string(value) : std::string();
  };
  const std::string state = folder_in("XDG_STATE_HOME");
  if (!state.empty()) return state + "/hazumi";
  const std::string home = folder_in("HOME");
  if (!home.empty()) return home + "/.local/state/hazumi";
  return Error{ErrorCode::kFailed, "", "XDG_STATE_HOME",
               "neither this nor HOME is the path of a folder, so that nothing can be kept safe "
               "from a crash; set one of them"};
}

}  // namespace hazumi::edit
