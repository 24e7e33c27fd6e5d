#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/project/items.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Rows of the dope sheet on which a bar is shown. Rows of regions and fills
// follow from their hinges instead.
struct BarRows {
  bool of_placement = false;         // that of what places the figure
  std::vector<std::string> joints;   // those of these joints, or of the root
  std::vector<std::string> objects;  // those of these held objects
};

struct BarTexts {
  const char *move, *stretch;  // hints while it is dragged
  const char* title;           // of its popup
  const char* remove;          // operator that removes it
};

struct BarDeclaration {
  BarKind kind;
  BarTexts texts;
  std::optional<SrgbColor> color;  // nothing: faint
  bool is_thin = false;            // not as high as its row
};

// A kind of bar; each is declared once, in bar_types.cpp.
class BarType : public BarDeclaration {
 public:
  explicit BarType(const BarDeclaration& declaration) : BarDeclaration(declaration) {}
  virtual ~BarType() = default;

  // The arguments `index` are those of the project's list of the kind.
  virtual int Num(const Project& project) const = 0;
  virtual ItemId Id(const Project& project, int index) const = 0;
  virtual ProjectFrames Frames(const Project& project, int index) const = 0;
  virtual std::string Title(const Project& project, int index) const = 0;
  virtual std::string Details(const Project& project, int index) const = 0;
  virtual BarRows Rows(const Project& project, int index) const = 0;
  // Run the operators of the kind. `change`: fields, or "first" and "last".
  virtual Result<Done> Edit(Editor* editor, int index, Json change) const = 0;
  virtual Result<Done> Remove(Editor* editor, int index) const = 0;
};

// All kinds of bars; bars that begin together lie on a row in this order.
const std::vector<const BarType*>& AllBarTypes();
const BarType& TypeOf(BarKind kind);

// Titles of spans without a name.
std::string TitleOf(const ProjectPlacement& span);
std::string TitleOf(const ProjectHold& hold);

}  // namespace hazumi::ui
