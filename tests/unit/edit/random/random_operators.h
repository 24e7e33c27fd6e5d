#pragma once

#include <string>
#include <vector>

#include "tests/support/random.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {

// Files for operators that read or write some.
struct RandomFiles {
  std::string folder;                   // to write into
  std::vector<std::string> projects;    // to open
  std::vector<std::string> characters;  // to import
  std::string mesh;                     // of a thing
};

// Parameters that an operator or action takes, though it may refuse them: mostly things that the
// project has, by what each parameter offers, and numbers that somebody might type; one in twenty
// is anything of its kind.
edit::Json RandomParameters(const std::string& id, const std::vector<edit::ParameterInfo>& infos,
                            const edit::Session& session, const RandomFiles& files, Random* random);

// Nothing that it must name or change is missing. Others are refused for certain.
bool HasWhatItNeeds(const std::string& id, const std::vector<edit::ParameterInfo>& infos,
                    const edit::Session& session);
// True of operators that need what few sessions have: they are tried more often.
bool IsSeldomPossible(const std::string& id);

// One of a list of operators or actions that has what it needs, nearly always; those of regions
// more often than their number says, and so is redo where there is something to redo.
template <typename T>
const T& SomeThatCanBeDone(const std::vector<T>& all, const edit::Session& session,
                           Random* random) {
  const bool wants_region = random->Chance(0.15);
  const bool wants_redo = session.document().redo_label() && random->Chance(0.15);
  const bool wants_seldom = !wants_region && !wants_redo && random->Chance(0.1);
  for (;;) {
    const T& some = all[random->Integer(0, static_cast<int>(all.size()) - 1)];
    const std::string id = some.id;
    if (wants_redo && id != "edit.redo") continue;
    if (wants_region && !wants_redo && !id.starts_with("region.")) continue;
    if (wants_seldom && !IsSeldomPossible(id)) continue;
    if (HasWhatItNeeds(id, some.parameters, session) || random->Chance(0.05)) return some;
  }
}

}  // namespace hazumi::test
