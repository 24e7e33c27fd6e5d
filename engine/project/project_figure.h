#pragma once

// Figure of a project, its skin, and meshes of things that are held.

#include <memory>
#include <optional>
#include <string>

#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"
#include "engine/project/json/extra_fields.h"

namespace hazumi {

// Which figure a project animates: a file, or a figure written into the project.
struct ProjectFigure {
  std::string file;           // as written, relative to the project's folder; empty: embedded
  std::string embedded_json;  // the figure as JSON text if embedded, unknown fields and all
  ExtraFields extra;          // beside "file"
  FigureSpec spec;            // what the file or the text says; not written

  // Equal as documents.
  bool operator==(const ProjectFigure& other) const {
    return file == other.file && embedded_json == other.embedded_json && extra == other.extra;
  }
};

// Where figure and keys were imported from, and how: what it takes to put changed keys back there.
struct ProjectSource {
  std::string file;             // its name, without a folder
  std::string character, clip;  // of several; empty: the only one, none
  std::string above;            // nodes on which the skeleton hangs: "Rig/root"; empty: none
  std::optional<double> fps;    // at which the clip was read; not given: its own
  bool z_up = false;            // else y
  double metres_per_unit = 1.0;
  std::optional<double> reduce_deg;  // not given: a key every frame
  bool file_hinges = false;          // of the file; else of a body
  bool file_facing = false;          // as the file has it; else turned so that it faces x
  ExtraFields extra;
  bool operator==(const ProjectSource&) const = default;
};

// Skins that come with the program, so that files need only name them.
enum class ShippedSkin { kHuman };  // for assets/figures/human.json

// Made when it is first asked for, and never again.
const std::shared_ptr<const Skin>& MeshesOf(ShippedSkin skin);

// The figure's skin, if it has one. Shared, because nothing changes it and it is large.
struct ProjectSkin {
  std::optional<ShippedSkin> shipped = {};
  std::shared_ptr<const Skin> skin;  // the project's own, if none is shipped

  explicit operator bool() const { return shipped || skin; }
  // Null: none.
  std::shared_ptr<const Skin> meshes() const { return shipped ? MeshesOf(*shipped) : skin; }
  // Equal as documents.
  bool operator==(const ProjectSkin& other) const {
    return shipped == other.shipped &&
           (skin == other.skin || (skin && other.skin && *skin == *other.skin));
  }
};

// The look of a held object: meshes bound to one bone, its own, and stretched to fill the box
// around its shape. Null: the shape itself.
struct ProjectMesh {
  std::shared_ptr<const Skin> skin;

  explicit operator bool() const { return skin != nullptr; }
  // Equal as documents.
  bool operator==(const ProjectMesh& other) const {
    return skin == other.skin || (skin && other.skin && *skin == *other.skin);
  }
};

}  // namespace hazumi
