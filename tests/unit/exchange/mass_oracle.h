#pragma once

// The shares of mass that a person has, and which bones make up what, told apart from the importer:
// by hand, for the spellings of the files that are read.

#include <map>
#include <string>

#include "engine/figure/figure_spec.h"

namespace hazumi::test {

// Percent of the body. [de Leva 1996, Table 4, male]
inline const std::map<std::string, double> kDeLeva = {
    {"head and neck", 6.94}, {"trunk", 43.46},    {"upper arm L", 2.71}, {"upper arm R", 2.71},
    {"forearm L", 1.62},     {"forearm R", 1.62}, {"hand L", 0.61},      {"hand R", 0.61},
    {"thigh L", 14.16},      {"thigh R", 14.16},  {"shank L", 4.33},     {"shank R", 4.33},
    {"foot L", 1.37},        {"foot R", 1.37}};

// Of a bone by its name; empty: none of these spellings.
std::string SegmentByHand(const std::string& bone);

// Percent of the mass by segment. A bone without a word of its own counts to its parent's.
std::map<std::string, double> SharesOf(const FigureSpec& figure);

}  // namespace hazumi::test
