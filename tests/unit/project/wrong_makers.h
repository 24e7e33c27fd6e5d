#pragma once

// Ways to do something wrong and to hear about it.

#include <functional>
#include <string>

#include "engine/project/compile.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_reader.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {

// Without the file, which differs from run to run.
inline std::string Complaint(Error error) {
  error.file.clear();
  return error.ToString();
}

template <typename T>
std::string Complaint(const Result<T>& result) {
  return result.ok() ? "no complaint" : Complaint(result.error());
}

using Say = std::function<std::string()>;

inline Say Text(std::string text) {
  return [text] { return Complaint(ParseProject(text, "wrong.kfa")); };
}

// The sample with one thing changed, read.
inline Say Read(Changes changes) {
  return [changes] {
    return Complaint(ParseProject(Changed(SampleProject(), changes).dump(), "wrong.kfa"));
  };
}
inline Say Read(std::string pointer, std::string value) { return Read({{pointer, value}}); }

// The sample's figure with one thing changed, read on its own.
inline Say Figure(std::string pointer, std::string value) {
  return [pointer, value] {
    const Json figure = Changed(SampleProject()["figure"], {{pointer, value}});
    return Complaint(ParseFigure(figure.dump(), "wrong.json"));
  };
}

// The same, good enough to be read, compiled.
inline Say Compile(Changes changes) {
  return [changes] {
    return Complaint(CompileAnimation(ParseGood(Changed(SampleProject(), changes))));
  };
}

// A document spoilt after it was read, as an editor could.
inline Say Spoilt(std::function<void(Project&)> spoil) {
  return [spoil] {
    Project project = ParseGood(SampleProject());
    spoil(project);
    return Complaint(CompileAnimation(project));
  };
}

// The sample with one thing changed: all that is odd about reading it.
inline Say Doubt(Changes changes) {
  return [changes] {
    std::string text;
    for (const Warning& warning : ParseGood(Changed(SampleProject(), changes)).read.warnings) {
      text += (text.empty() ? "" : "\n") + warning.place + ": " + warning.message;
    }
    return text;
  };
}
inline Say Doubt(std::string pointer, std::string value) { return Doubt({{pointer, value}}); }

// The last warning.
inline Say Warn(Changes changes) {
  return [changes] {
    const auto compiled = CompileAnimation(ParseGood(Changed(SampleProject(), changes)));
    if (!compiled.ok()) return Complaint(compiled);
    const Warning& warning = compiled.value().warnings.back();
    return warning.place + ": " + warning.message;
  };
}

}  // namespace hazumi::testing
