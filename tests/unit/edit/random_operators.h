#pragma once

#include "engine/project/project.h"
#include "tests/support/random.h"
#include "ui/edit/operator.h"

namespace hazumi::test {

// Parameters that an operator takes, though it may refuse them: likely names, and keys and regions
// that the project has.
edit::Json RandomParameters(const edit::Operator& op, const Project& project, Random* random);

}  // namespace hazumi::test
