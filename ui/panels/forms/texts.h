#pragma once

#include <string>
#include <vector>

#include "ui/edit/parameters.h"

namespace hazumi::ui {

// What a form calls a parameter: "First frame"; a key of the catalogue.
std::string LabelOf(const edit::ParameterInfo& info);
// What it calls several in one row, by the name of the first of them: "Frames" of "first" and
// "last". Empty if that one has a row of its own.
std::string LabelOfRow(const std::string& id, const std::string& first_name);
// The names of the parameters of such a row.
std::vector<std::string> NamesInRow(const std::string& first_name);

// What a word, or a number by its parameter's name, means to an operator; empty if it speaks for
// itself.
std::string MeaningOf(const std::string& id, const std::string& word);

// All texts above, for the catalogue.
std::vector<std::string> AllFormTexts();

// Whether a parameter that may be left out belongs to what the form is for.
bool IsMain(const std::string& id, const std::string& name);

}  // namespace hazumi::ui
