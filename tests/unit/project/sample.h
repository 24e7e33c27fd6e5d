#pragma once

// A small but complete project for the tests, and ways to change it.

#include <string>
#include <utility>
#include <vector>

#include "engine/project/json/json.h"
#include "engine/project/project.h"
#include "tests/support/temporary_folder.h"

namespace hazumi::testing {

// Every kind of object of the format, once at least. The figure is embedded.
Json SampleProject();

// A change: a JSON pointer and the new value as JSON text; empty: the field is removed.
using Changes = std::vector<std::pair<std::string, std::string>>;
Json Changed(Json document, const Changes& changes);

// Demands that it can be read.
Project ParseGood(const Json& document);

using test::TemporaryFolder;

std::string ReadFile(const std::string& path);
void WriteFile(const std::string& path, const std::string& text);

}  // namespace hazumi::testing
