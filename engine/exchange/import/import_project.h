#pragma once

#include "engine/base/result.h"
#include "engine/exchange/import/import_options.h"

namespace hazumi {

// A project whose figure is made from the character's bones, with masses and limits, and whose keys
// are one of its clips. Figures are hinges: what else moves a bone is dropped and named in the
// report, with the error that this leaves. Errors: kSemantics if no figure can be made of it, or
// there is no such clip; kSchema if it has more or larger numbers than a project's file holds.
Result<Imported> ImportProject(const Character& character, const ImportOptions& options);

}  // namespace hazumi
