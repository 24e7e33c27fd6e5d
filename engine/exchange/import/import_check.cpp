#include "engine/exchange/import/import_check.h"

#include "engine/base/text.h"
#include "engine/project/compile.h"
#include "engine/project/fields/field.h"
#include "engine/project/figure_file.h"

namespace hazumi {

namespace {

constexpr double kTallest = 5000.0;  // [m]; by its height it weighs 6e8 kg, and a file holds 1e9

Error WrongSize(const std::string& message) {
  return {ErrorCode::kSemantics, "", "size",
          message + "; give its unit, or its height (--unit, --height)"};
}

bool IsHeld(const Skin& skin) {
  for (const SkinMesh& mesh : skin.meshes) {
    for (const SkinMesh::Bind& bind : mesh.binds)
      if (!(bind.inverse_bind.cwiseAbs().maxCoeff() <= kLargestNumber)) return false;
  }
  return true;
}

}  // namespace

std::optional<Error> WhyTooTall(const WorldFrame& world) {
  if (world.height <= kTallest) return std::nullopt;
  return WrongSize("the figure is " + FormatShort(world.height) + " m tall, with " +
                   FormatShort(world.metres) + " m to a unit; " + FormatShort(kTallest) +
                   " m are the most");
}

std::optional<Error> WhyNoProject(const Project& project) {
  const Result<FigureSpec> figure = ParseFigure(project.figure.embedded_json, "");
  if (!figure.ok()) return figure.error();
  if (project.skin.skin && !IsHeld(*project.skin.skin))
    return WrongSize("the skin is bound at positions or scales beyond 1e9");
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) return compiled.error();
  return std::nullopt;
}

}  // namespace hazumi
