#pragma once

#include "engine/exchange/import/import_project.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// Makes an imported project that of the session: not saved, without a file, nothing to undo.
void TakeImported(Imported imported, Session* session);

}  // namespace hazumi::edit
