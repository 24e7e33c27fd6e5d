#pragma once

#include <vector>

#include "tests/bench/subject.h"

namespace hazumi::bench {

// Random states away from the poses in which the hinges of a group line up.
std::vector<Question> RandomQuestions(const Figure& figure, int count);

// Ends the program with a message if any answer differs from ours by more than 1e-9 of its size:
// timing a wrong model would be worthless. Of the forward dynamics, whose answer may be
// ill-conditioned, the torques that our inverse dynamics gives for it.
void DemandAgreement(const NamedMaker& maker, const Figure& figure);
void DemandForwardAgreement(const NamedMaker& maker, const Figure& figure);
// Of a subject that is ready, asked these; their tau are all torques that act.
void DemandForwardAgreement(const std::string& name, Subject* subject, const Figure& figure,
                            std::vector<Question> questions);

}  // namespace hazumi::bench
