// The sound that is heard with the motion, and the picture or video that it is made by.

#include "engine/project/project_files.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using PathOfFile = std::string (*)(const Project& project, const std::string& project_path);

// Sets the fields that are given; the others stay. The item needs a file. Naming a file is
// agreement to open it.
template <typename Item>
Result<Done> SetItem(Session* session, const Parameters& p, const char* label, const char* what,
                     std::optional<Item> Project::*item, PathOfFile path) {
  Result<Done> done = session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        Item changed = (project->*item).value_or(Item());
        if (Result<Done> set = SetFields(p, &changed); !set.ok()) return set;
        if (changed.file.empty()) return Refusal("file", std::string("name a ") + what);
        project->*item = std::move(changed);
        return Done();
      },
      p.text("drag"));
  if (!done.ok() || !p.has("file")) return done;
  const std::string& project = session->document().path();
  session->media().Allow(path(session->project(), project));
  KeepFilesOf(session->project(), project);
  return done;
}

template <typename Item>
Result<Done> RemoveItem(Session* session, const char* label, const char* none,
                        std::optional<Item> Project::*item) {
  return session->Edit(label, [&](Project* project) -> Result<Done> {
    if (!(project->*item)) return Refusal("", none);
    (project->*item).reset();
    return Done();
  });
}

Result<Done> SetAudio(Session* session, const Parameters& p) {
  return SetItem(session, p, "Set sound", "sound file", &Project::audio, SoundPath);
}
Result<Done> RemoveAudio(Session* session, const Parameters&) {
  return RemoveItem(session, "Remove sound", "the project has no sound", &Project::audio);
}
Result<Done> SetReference(Session* session, const Parameters& p) {
  return SetItem(session, p, "Set reference", "picture or video", &Project::reference,
                 ReferencePath);
}
Result<Done> RemoveReference(Session* session, const Parameters&) {
  return RemoveItem(session, "Remove reference", "the project has no reference picture",
                    &Project::reference);
}

}  // namespace

std::vector<Operator> MediaOperators() {
  return {
      {"audio.set", "Set sound",
       "Sets the sound file that is heard with the motion; what is not given stays.",
       Joined({FieldsOf<ProjectAudio>(), {kDrag}}), SetAudio},
      {"audio.remove", "Remove sound", "Takes the sound away; its file stays.", {}, RemoveAudio},
      {"reference.set", "Set reference",
       "Sets the picture or video that is seen to animate by; what is not given stays.",
       Joined({FieldsOf<ProjectReference>(), {kDrag}}), SetReference},
      {"reference.remove",
       "Remove reference",
       "Takes the reference picture away; its file stays.",
       {},
       RemoveReference}};
}

}  // namespace hazumi::edit
