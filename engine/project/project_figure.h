#pragma once

#include <string>

#include "engine/figure/figure_spec.h"
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

}  // namespace hazumi
