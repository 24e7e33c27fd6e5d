#include "engine/project/figure_reader.h"

#include "engine/project/figure_fields.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

Result<FigureSpec> LoadFigure(const std::string& path, std::vector<Warning>* warnings,
                              std::vector<Warning>* unknown) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  return ParseFigure(text.value(), path, warnings, unknown);
}

Result<FigureSpec> ParseFigure(std::string_view text, const std::string& file_name,
                               std::vector<Warning>* warnings, std::vector<Warning>* unknown) {
  FirstError errors;
  const std::optional<Json> json = ParseJson(text, &errors);
  if (!json) return errors.In(file_name);
  FigureSpec spec = ReadFigure(*json, {"", &errors, warnings, unknown});
  if (!errors.ok()) return errors.In(file_name);
  return spec;
}

}  // namespace hazumi
