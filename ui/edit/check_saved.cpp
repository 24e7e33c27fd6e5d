#include "ui/edit/check_saved.h"

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"

namespace hazumi::edit {

Result<Done> CheckSaved(const Project& project, const std::string& path,
                        const std::atomic<bool>* cancel) {
  const Result<std::string> text = TextToSave(project, path);
  if (!text.ok()) return text.error();
  const Result<Project> read = ParseProject(text.value(), path);
  if (!read.ok()) return read.error();
  const Result<Compiled> compiled = CompileAnimation(read.value(), cancel);
  if (!compiled.ok()) return compiled.error();
  BakeOptions options;
  options.cancel = cancel;
  options.keep_frames = false;
  const Result<Motion> motion = Bake(compiled.value().animation, options);
  if (!motion.ok()) return motion.error();
  return Done();
}

}  // namespace hazumi::edit
