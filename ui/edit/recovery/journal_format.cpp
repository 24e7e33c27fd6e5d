#include "ui/edit/recovery/journal_format.h"

#include <algorithm>
#include <cstdint>

#include "engine/base/utf8.h"
#include "ui/edit/document/document.h"

namespace hazumi::edit {

namespace {

constexpr int kVersion = 1;

std::string LineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Names of files are bytes; such as are no text are written as numbers.
Json PathToJson(const std::string& path) {
  if (FindInvalidUtf8(path) == std::string::npos) return path;
  return std::vector<uint8_t>(path.begin(), path.end());
}

std::optional<std::string> PathFrom(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) return std::nullopt;
  std::string path;
  for (const Json& byte : json) {
    if (!byte.is_number_unsigned() || byte.get<uint64_t>() > 255) return std::nullopt;
    path += static_cast<char>(byte.get<uint8_t>());
  }
  return path;
}

// Lines that have an end.
std::vector<JournalLine> LinesOf(std::string_view text, bool* is_cut_off) {
  std::vector<JournalLine> lines;
  for (;;) {
    const size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    Json json = Json::parse(text.substr(0, end), nullptr, /*allow_exceptions=*/false);
    lines.push_back(
        {static_cast<int>(lines.size()) + 1, json.is_object() ? std::move(json) : Json()});
    text.remove_prefix(end + 1);
  }
  *is_cut_off = !text.empty();
  return lines;
}

}  // namespace

std::string JournalHead(const DocumentFile& file, const std::string& base, const Json& state) {
  Json head = {{"journal", kVersion}, {"path", PathToJson(file.path)}};
  if (!file.digest.empty()) head["file"] = file.digest;
  return LineOf(head) + LineOf({{"base", base}}) + StateLine(state);
}

std::string StateLine(const Json& state) { return LineOf({{"state", state}}); }

std::string OperatorLine(const std::string& id, const Json& parameters) {
  Json line = {{"op", id}};
  line.update(parameters);
  return LineOf(line);
}

std::string DigestLine(std::string_view text) { return LineOf({{"digest", DigestOf(text)}}); }

int JournalText::num_operators() const {
  return static_cast<int>(std::count_if(
      lines.begin(), lines.end(), [](const JournalLine& line) { return line.is_operator(); }));
}

Result<JournalText> ReadJournal(std::string_view text, const std::string& file) {
  JournalText journal;
  std::vector<JournalLine> lines = LinesOf(text, &journal.is_cut_off);
  if (lines.empty() || !lines[0].json.contains("journal")) {
    return Error{ErrorCode::kSyntax, file, "line 1", "this is not a journal of Hazumi"};
  }
  if (lines[0].json["journal"] != kVersion) {
    return Error{ErrorCode::kSchema, file, "line 1",
                 "a journal of version " + lines[0].json["journal"].dump() +
                     "; recover it with the Hazumi that wrote it"};
  }
  const std::optional<std::string> path = PathFrom(lines[0].json.value("path", Json()));
  if (!path) return Error{ErrorCode::kSchema, file, "line 1", "does not say the document's path"};
  if (lines.size() < 2 || !lines[1].json.contains("base") || !lines[1].json["base"].is_string()) {
    return Error{ErrorCode::kSyntax, file, "line 2",
                 "the project that the journal begins with is damaged; nothing can be recovered"};
  }
  journal.file.path = *path;
  const Json digest = lines[0].json.value("file", Json());
  if (digest.is_string()) journal.file.digest = digest.get<std::string>();
  journal.base = lines[1].json["base"].get<std::string>();
  journal.lines.assign(lines.begin() + 2, lines.end());
  return journal;
}

}  // namespace hazumi::edit
