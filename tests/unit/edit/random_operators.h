#pragma once

#include "tests/support/random.h"
#include "ui/edit/operator.h"

namespace hazumi::test {

// Parameters that an operator takes, though it may refuse them: of names and numbers that mean
// something to one operator or another.
edit::Json RandomParameters(const edit::Operator& op, Random* random);

}  // namespace hazumi::test
