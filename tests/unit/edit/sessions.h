#pragma once

#include <gtest/gtest.h>

#include "engine/project/project_writer.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {

// Runs an operator that must succeed.
inline void Do(edit::Session* session, const std::string& id, const edit::Json& parameters = {}) {
  const Result<Done> done =
      session->Run(id, parameters.is_null() ? edit::Json::object() : parameters);
  EXPECT_TRUE(done.ok()) << id << " " << (done.ok() ? "" : done.error().ToString());
}

// The error of an operator that must fail and change nothing: "ID.PARAMETER: ..." or "ID: ...".
inline Error Refused(edit::Session* session, const std::string& id, const edit::Json& parameters) {
  const std::string before = WriteProject(session->project());
  const size_t steps = session->document().num_steps();
  const Result<Done> done = session->Run(id, parameters);
  EXPECT_FALSE(done.ok()) << id;
  EXPECT_EQ(WriteProject(session->project()), before);
  EXPECT_EQ(session->document().num_steps(), steps);
  return done.ok() ? Error() : done.error();
}

}  // namespace hazumi::test
