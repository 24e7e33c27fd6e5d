// Markers and the preview range.

#include <cmath>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kIndex = {"index", kInteger, true, "which marker, counted from 0",
                              Thing::kMarker};

Result<Done> AddMarker(Session* session, const Parameters& p) {
  return session->Edit("Add marker", [&](Project* project) -> Result<Done> {
    ProjectMarker marker;
    marker.frame = static_cast<int>(std::lround(session->frame()));
    if (Result<Done> set = SetFields(p, &marker); !set.ok()) return set;
    if (!p.has("name")) marker.name = "F_" + std::to_string(marker.frame);
    project->markers.push_back(std::move(marker));
    return Done();
  });
}

// `change(markers, index)` of one marker.
template <typename Change>
Result<Done> ChangeMarker(Session* session, const Parameters& p, const char* label, Change change) {
  return session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        const int index = p.integer("index");
        if (index < 0 || index >= static_cast<int>(project->markers.size())) {
          return Refusal("index", "there is no such marker; there are " +
                                      std::to_string(project->markers.size()));
        }
        change(&project->markers, index);
        return Done();
      },
      p.text("drag"));
}

using Markers = std::vector<ProjectMarker>;

Result<Done> MoveMarker(Session* session, const Parameters& p) {
  return ChangeMarker(session, p, "Move marker", [&](Markers* markers, int index) {
    (*markers)[index].frame = p.integer("to");
  });
}

Result<Done> RenameMarker(Session* session, const Parameters& p) {
  return ChangeMarker(session, p, "Rename marker", [&](Markers* markers, int index) {
    (*markers)[index].name = p.text("name");
  });
}

Result<Done> RemoveMarker(Session* session, const Parameters& p) {
  return ChangeMarker(session, p, "Remove marker", [](Markers* markers, int index) {
    markers->erase(markers->begin() + index);
  });
}

Result<Done> SetPreview(Session* session, const Parameters& p) {
  const bool off = p.yes("off"), has_frames = p.has("first") || p.has("last");
  if (off == has_frames) {
    return Refusal("off", off ? "goes without first and last" : "or first or last must be given");
  }
  return session->Edit(
      "Set preview range",
      [&](Project* project) -> Result<Done> {
        if (off) {
          project->preview.reset();
          return Done();
        }
        ProjectFrames preview = project->preview.value_or(
            ProjectFrames{project->frames.first, project->frames.last, {}});
        if (Result<Done> set = SetFields(p, &preview); !set.ok()) return set;
        if (preview.first > preview.last) {
          return Refusal("first", "must not come after last, " + std::to_string(preview.last));
        }
        project->preview = std::move(preview);
        return Done();
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> TimeOperators() {
  return {{"marker.add", "Add marker",
           "Gives a frame a name. Not given: the current frame; F_ and its number.",
           FieldsOf<ProjectMarker>(), AddMarker},
          {"marker.move",
           "Move marker",
           "Moves a marker to another frame.",
           {kIndex, {"to", kInteger, true, "its new frame"}, kDrag},
           MoveMarker},
          {"marker.rename",
           "Rename marker",
           "Gives a marker another name.",
           {kIndex, {"name", kText, true, "its new name"}},
           RenameMarker},
          {"marker.remove", "Remove marker", "Takes a marker away.", {kIndex}, RemoveMarker},
          {"time.preview", "Set preview range", "Sets the part of the animation that is played.",
           Joined({FieldsOf<ProjectFrames>(),
                   {{"off", kYesNo, false, "true: all is played again"}, kDrag}}),
           SetPreview}};
}

}  // namespace hazumi::edit
