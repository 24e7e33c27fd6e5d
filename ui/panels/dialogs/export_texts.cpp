#include <algorithm>

#include "engine/base/filled.h"
#include "ui/panels/dialogs/export_summary.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

namespace {

// "2 regions", or "1 region".
std::string Count(int count, const char* one, const char* many) {
  return count == 1 ? std::string(one) : Filled(many, count);
}

std::string LengthText(const Editor& editor) {
  const edit::ExportSettings settings = ExportSettingsOf(editor);
  const ProjectRate& rate = editor.session().project().fps;
  const int frames = settings.last - settings.first + 1;
  const double fps = static_cast<double>(rate.num) / rate.den;
  return Count(frames, Tr("1 frame"), Tr("%d frames")) + Filled(Tr(", %.5g fps, "), fps) +
         Filled(Tr("%.3g s"), frames / fps);
}

std::string MotionLine(const Editor& editor, const ExportSummary& summary) {
  return Count(summary.joints, Tr("1 joint"), Tr("%d joints")) + Tr(", ") + LengthText(editor) +
         Tr(", ") + SizeText(summary.num_bytes);
}

void AddGltf(const ExportSummary& summary, std::vector<std::string>* facts) {
  std::string line = Filled(Tr("%d nodes, "), summary.nodes);
  if (summary.meshes > 0) {
    line += Count(summary.meshes, Tr("1 mesh"), Tr("%d meshes")) +
            Filled(Tr(" of %d triangles, "), summary.triangles);
  }
  facts->push_back(line +
                   Filled(Tr("an animation of %d channels; y up, metres"), summary.channels));
  const std::string extras = Count(summary.regions, Tr("1 region"), Tr("%d regions")) + Tr(", ") +
                             Count(summary.placements, Tr("1 placement"), Tr("%d placements")) +
                             Tr(", ") + Count(summary.events, Tr("1 event"), Tr("%d events"));
  facts->push_back(Tr("In its extras: ") + extras);
}

void AddOfFormat(const edit::ExportSettings& settings, const ExportSummary& summary,
                 std::vector<std::string>* facts) {
  switch (settings.format) {
    case MotionFormat::kBvh:
      facts->push_back(Filled(Tr("%d channels, %s up, a unit is %g m"), summary.channels,
                              settings.up == UpAxis::kY ? "y" : "z", settings.metres_per_unit));
      break;
    case MotionFormat::kGltf:
    case MotionFormat::kGlb:
      AddGltf(summary, facts);
      break;
    case MotionFormat::kCsv:
      facts->push_back(
          Filled(Tr("%d columns, a row for each frame; z up, metres, degrees"), summary.channels));
      break;
    case MotionFormat::kJson:
      facts->emplace_back(Tr("A line for each frame; z up, metres, degrees"));
      break;
  }
}

bool HasRegions(MotionFormat format) {
  return format == MotionFormat::kGltf || format == MotionFormat::kGlb ||
         format == MotionFormat::kJson;
}

bool HasSound(const Editor& editor) {
  const std::optional<ProjectAudio>& audio = editor.session().project().audio;
  return audio && !audio->mute;
}

void AddHeldObjects(const Project& project, MotionFormat format, const ExportSummary& summary,
                    std::vector<std::string>* left_out) {
  if (format == MotionFormat::kJson) return;
  for (const ProjectHeldObject& object : project.held_objects) {
    if (!summary.names.contains(object.name)) left_out->push_back(object.name);
  }
}

}  // namespace

std::vector<std::string> ExportFacts(const Editor& editor, const ExportSummary* summary) {
  const ExportState& state = editor.dialogs.exporting;
  if (state.is_video) {
    return {LengthText(editor) + Filled(Tr(", %d x %d pixels"), state.width, state.height),
            HasSound(editor) ? Tr("H.264 with its sound in AAC, made by the program ffmpeg")
                             : Tr("H.264 without sound, made by the program ffmpeg")};
  }
  if (!summary) return {};
  if (IsOnto(editor)) {
    if (summary->joints == 0) return {Tr("No bone has changed: the file is as it was.")};
    const std::string& clip = editor.session().project().source->clip;
    return {Count(summary->joints, Tr("1 bone has changed"), Tr("%d bones have changed")) +
                Tr(", ") + SizeText(summary->num_bytes),
            (clip.empty() ? Tr("Its clip becomes: ")
                          : Filled(Tr("The clip \"%s\" becomes: "), clip.c_str())) +
                LengthText(editor) + Tr("; other clips stay as they are")};
  }
  std::vector<std::string> facts = {MotionLine(editor, *summary)};
  AddOfFormat(ExportSettingsOf(editor), *summary, &facts);
  return facts;
}

std::vector<std::string> LeftOut(const Editor& editor, const ExportSummary* summary) {
  const ExportState& state = editor.dialogs.exporting;
  const Project& project = editor.session().project();
  const edit::ExportSettings settings = ExportSettingsOf(editor);
  std::vector<std::string> left_out;
  const int num_frames = project.frames.last - project.frames.first;
  const int rest = num_frames - (settings.last - settings.first);
  if (rest > 0) left_out.push_back(Count(rest, Tr("1 frame"), Tr("%d frames")));
  if (state.is_video || !summary) return left_out;
  const int regions = static_cast<int>(project.regions.size());
  if (regions > 0 && (IsOnto(editor) || !HasRegions(settings.format))) {
    left_out.push_back(Count(regions, Tr("1 region"), Tr("%d regions")));
  }
  AddHeldObjects(project, settings.format, *summary, &left_out);
  for (const ProjectSceneObject& object : project.scene.objects) {
    if (!summary->names.contains(object.name)) left_out.push_back(object.name);
  }
  if (IsOnto(editor)) return left_out;
  const bool drops_skin = project.skin && settings.skin != edit::ExportSkin::kCharacter;
  if (project.skin && (!HasMeshes(state) || drops_skin)) {
    left_out.emplace_back(Tr("the character's meshes"));
  }
  return left_out;
}

}  // namespace hazumi::ui
