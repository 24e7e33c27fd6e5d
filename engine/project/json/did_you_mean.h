#pragma once

// Internal.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

// Single-character changes that turn one name into the other, where swapping two neighbours counts
// as one (optimal string alignment distance).
int EditDistance(std::string_view a, std::string_view b);

// The candidate nearest to `name`, if it is near enough to be a slip of the pen.
std::optional<std::string> Nearest(std::string_view name,
                                   const std::vector<std::string>& candidates);

// As Nearest, or else the candidate that only goes on after the name's end: "step" for "step_s".
std::optional<std::string> NearestField(std::string_view name,
                                        const std::vector<std::string>& candidates);

// Candidate nearest to `name`, at any distance; empty if there is none.
std::string NearestOf(std::string_view name, const std::vector<std::string>& candidates);

// What to do about a wrong name: `did you mean "x"?`, else `use one of "x", "y"`.
std::string Suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace hazumi
