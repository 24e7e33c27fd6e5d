#pragma once

// A summary of a motion file, read from its bytes: the preview of an export. And the sentences of
// the export dialog about it, in the language of the interface.

#include <set>
#include <string>
#include <vector>

#include "engine/exchange/export_motion.h"

namespace hazumi::ui {

class Editor;

struct ExportSummary {
  size_t num_bytes = 0;
  int joints = 0;    // of the skeleton
  int channels = 0;  // BVH: numbers a frame; glTF: of its animations; CSV: columns
  // Of glTF.
  int nodes = 0, meshes = 0, triangles = 0, animations = 0;
  int regions = 0, placements = 0, events = 0;  // in extras
  std::set<std::string> names;                  // of nodes
  // What is shown of it: the beginning of a text, cut to some lines, or the tree of glTF nodes.
  std::string head;
  // Of CSV: a line for each column, its name and its first values.
  std::vector<std::vector<std::string>> columns;
};

// Of bytes that ExportMotion made. On any thread.
ExportSummary SummaryOf(MotionFormat format, const std::string& bytes);

// "812 bytes", "1.2 MB": powers of 1000.
std::string SizeText(size_t num_bytes);

// "22 joints, 48 frames, 30 fps, 1.6 s, 310 kB" and what the format has beside that, a line each.
// `summary` is not needed for a video.
std::vector<std::string> ExportFacts(const Editor& editor, const ExportSummary* summary);
// Lists what a user might look for in the file and will not find: "2 regions", "ball".
std::vector<std::string> LeftOut(const Editor& editor, const ExportSummary* summary);

}  // namespace hazumi::ui
