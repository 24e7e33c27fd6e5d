#pragma once

// A sweep: variations of one project. A sweep file (JSON, format "hazumi-sweep") names fields of
// the document, the values that each takes, and what is measured of each motion.
// A cell is one variation; cells are counted from 0.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/address/field_address.h"
#include "engine/project/project.h"

namespace hazumi {

enum class SweepCombine { kGrid, kList, kRandom };
// kWhole: as kLinear, to the nearest whole number.
enum class SweepSpacing { kLinear, kLog, kWhole };

// A value of a field as it stands in a file: 0.8, "exact", [1, 0, 0].
struct JsonValue {
  std::string text;
  bool operator==(const JsonValue&) const = default;
};

// One field, or several that are given the same value, and the values: either `values`, or numbers
// from `from` to `to`.
struct SweepAxis {
  std::string field;
  std::vector<std::string> also;
  std::vector<JsonValue> values;
  std::optional<double> from, to;
  std::optional<int> count;  // of numbers, both ends among them; not with kRandom
  SweepSpacing spacing = SweepSpacing::kLinear;
  ExtraFields extra;
  bool operator==(const SweepAxis&) const = default;
};

// The first one and the others.
std::vector<const std::string*> FieldsOf(const SweepAxis& axis);

// What is measured: a quantity of quantities.h.
struct SweepMeasure {
  std::string name;  // of its column; empty: as quantity and `of` say
  std::string quantity;
  std::string of;  // a held object, joint, hinge or region, as the quantity has it
  std::optional<double> frame;
  ExtraFields extra;
  bool operator==(const SweepMeasure&) const = default;
};

// What is drawn of each cell: some frames beside each other, or a video.
struct SweepPicture {
  std::vector<int> frames;
  bool video = false;
  std::vector<std::string> options;  // of drawing, as on the command line: "--camera", "front"
  ExtraFields extra;
  bool operator==(const SweepPicture&) const = default;
};

struct SweepPlan {
  std::string project;  // a file, relative to the sweep file's folder
  SweepCombine combine = SweepCombine::kGrid;
  std::vector<SweepAxis> vary;
  std::optional<int> count;           // of cells: kRandom
  int seed = 1;                       // kRandom
  std::vector<SweepMeasure> measure;  // empty: DefaultMeasures of quantities.h
  std::optional<SweepPicture> picture;
  ExtraFields extra;
  ReadReport read;
  bool operator==(const SweepPlan&) const = default;
};

inline constexpr double kMostCells = 1e6;

// Reads and checks a sweep file by itself: shape, ranges, a number of cells from 1 to kMostCells.
// Errors: kNoInput, kSyntax, kSchema, with file, place and remedy.
Result<SweepPlan> LoadSweep(const std::string& path);
Result<SweepPlan> ParseSweep(std::string_view text, const std::string& file_name);
std::string WriteSweep(const SweepPlan& plan);

long CellCount(const SweepPlan& plan);
// How many values each axis has: the grid's edges. Of other sweeps every axis has CellCount.
std::vector<int> AxisSizes(const SweepPlan& plan);
// The number along each axis of a grid's cell: the last axis goes fastest.
std::vector<int> AxisNumbers(const SweepPlan& plan, long cell);

// The value of each axis in a cell, as JSON. The random ones depend on seed, cell and axis alone.
std::vector<std::string> ValuesOf(const SweepPlan& plan, long cell);

// Tries every value of a grid or list, alone, and the ends of random ones, on the project. Errors:
// kSchema, whose place is that of the value in the sweep file: no such field, another type, out of
// range.
Result<Done> CheckFields(const SweepPlan& plan, const Project& project);

// Gives a project the values of a cell. Errors: as of SetField.
Result<Done> ApplyCell(const SweepPlan& plan, long cell, Project* project);

}  // namespace hazumi
