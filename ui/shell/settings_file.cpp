#include "ui/shell/settings_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "engine/base/atomic_file.h"
#include "engine/project/json/text_file.h"
#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

namespace fs = std::filesystem;

namespace {

std::string Variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

fs::path SettingsFolder() {
  const std::string config = Variable("XDG_CONFIG_HOME");
  return (config.empty() ? fs::path(HomeFolder()) / ".config" : fs::path(config)) / "hazumi";
}

// Of the system, by the variables that gettext reads.
Language SystemLanguage() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const std::string value = Variable(name);
    if (!value.empty()) return value.starts_with("ja") ? Language::kJapanese : Language::kEnglish;
  }
  return Language::kEnglish;
}

Error Wrong(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

// A number in [least, most], if there is one.
std::optional<Error> ReadNumber(const Json& json, const std::string& name, double least,
                                double most, double* value) {
  if (!json.contains(name)) return std::nullopt;
  if (!json[name].is_number()) return Wrong(name, "must be a number");
  const double number = json[name].get<double>();
  if (!(number >= least && number <= most)) return Wrong(name, "is out of range");
  *value = number;
  return std::nullopt;
}

// One of two words.
std::optional<Error> ReadWord(const Json& json, const char* name, const char* yes, const char* no,
                              bool* value) {
  if (!json.contains(name)) return std::nullopt;
  if (json[name] != yes && json[name] != no) {
    return Wrong(name, std::string("must be \"") + yes + "\" or \"" + no + "\"");
  }
  *value = json[name] == yes;
  return std::nullopt;
}

std::optional<Error> ReadShares(const Json& json, Shares* shares) {
  if (!json.contains("shares")) return std::nullopt;
  const Json& given = json["shares"];
  if (!given.is_object()) return Wrong("shares", "must be an object");
  if (auto error = ReadNumber(given, "side", 0.05, 0.95, &shares->side)) return error;
  if (auto error = ReadNumber(given, "bottom", 0.05, 0.95, &shares->bottom)) return error;
  return ReadNumber(given, "outliner", 0.05, 0.95, &shares->outliner);
}

std::optional<Error> ReadFiles(const Json& json, const char* name,
                               std::vector<std::string>* files) {
  if (!json.contains(name)) return std::nullopt;
  const Json& given = json[name];
  const auto is_text = [](const Json& file) { return file.is_string(); };
  if (!given.is_array() || !std::all_of(given.begin(), given.end(), is_text)) {
    return Wrong(name, "must be a list of paths");
  }
  *files = given.get<std::vector<std::string>>();
  return std::nullopt;
}

std::optional<Error> ReadKeymap(const Json& json, Keymap* keymap) {
  if (!json.contains("keymap")) return std::nullopt;
  const Error wrong =
      Wrong("keymap", "must be a list of {\"place\", \"key\", \"to\"} with names of keys");
  if (!json["keymap"].is_array()) return wrong;
  keymap->clear();
  for (const Json& entry : json["keymap"]) {
    const auto text = [&](const char* name) {
      const bool has = entry.is_object() && entry.contains(name) && entry[name].is_string();
      return has ? entry[name].get<std::string>() : std::string("?");
    };
    const std::optional<Place> place = PlaceNamed(text("place"));
    const std::optional<Chord> original = ChordNamed(text("key"));
    const std::optional<Chord> chord = text("to").empty() ? Chord() : ChordNamed(text("to"));
    if (!place || !original || !chord) return wrong;
    keymap->push_back({*place, *original, *chord});
  }
  return std::nullopt;
}

Json JsonOf(const Keymap& keymap) {
  Json list = Json::array();
  for (const KeyChange& change : keymap) {
    list.push_back({{"place", NameOf(change.place)},
                    {"key", NameOf(change.original)},
                    {"to", NameOf(change.chord)}});
  }
  return list;
}

std::optional<Error> ReadAll(const Json& json, Settings* settings) {
  bool is_japanese = settings->language == Language::kJapanese;
  if (auto error = ReadWord(json, "theme", "dark", "light", &settings->dark)) return error;
  if (auto error = ReadWord(json, "language", "ja", "en", &is_japanese)) return error;
  settings->language = is_japanese ? Language::kJapanese : Language::kEnglish;
  settings->has_chosen_language = json.contains("language");
  if (auto error = ReadNumber(json, "scale", 0.75, 3.0, &settings->scale)) return error;
  if (auto error = ReadShares(json, &settings->shares)) return error;
  if (auto error = ReadFiles(json, "recent_files", &settings->recent_files)) return error;
  if (auto error = ReadFiles(json, "opened_outside", &settings->opened_outside)) return error;
  if (auto error = ReadKeymap(json, &settings->keymap)) return error;
  if (!json.contains("has_seen_first_steps")) return std::nullopt;
  if (!json["has_seen_first_steps"].is_boolean()) {
    return Wrong("has_seen_first_steps", "must be true or false");
  }
  settings->has_seen_first_steps = json["has_seen_first_steps"].get<bool>();
  return std::nullopt;
}

}  // namespace

std::string SettingsPath() { return (SettingsFolder() / "settings.json").string(); }
std::string PosesPath() { return (SettingsFolder() / "poses.json").string(); }

std::string WriteSettings(const Settings& settings) {
  Json json = {{"version", 1},
               {"theme", settings.dark ? "dark" : "light"},
               {"scale", settings.scale},
               {"shares",
                {{"side", settings.shares.side},
                 {"bottom", settings.shares.bottom},
                 {"outliner", settings.shares.outliner}}},
               {"recent_files", settings.recent_files},
               {"opened_outside", settings.opened_outside},
               {"has_seen_first_steps", settings.has_seen_first_steps},
               {"keymap", JsonOf(settings.keymap)}};
  if (settings.has_chosen_language) {
    json["language"] = settings.language == Language::kJapanese ? "ja" : "en";
  }
  // A path that is no UTF-8 would otherwise throw.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Settings> ReadSettings(const std::string& text, const Settings& otherwise) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return Error{ErrorCode::kSyntax, "", "", "must be a JSON object"};
  Settings settings = otherwise;
  if (const std::optional<Error> error = ReadAll(json, &settings)) return *error;
  return settings;
}

void SettingsFile::Load(Editor* editor) {
  std::error_code unknown;
  editor->settings.language = SystemLanguage();
  if (!fs::exists(path_, unknown)) {
    last_ = {};
    last_.language = editor->settings.language;
    return;
  }
  const std::vector<std::string> opened = editor->settings.recent_files;
  const Result<std::string> text = ReadTextFile(path_);
  const Result<Settings> read =
      text.ok() ? ReadSettings(text.value(), editor->settings) : Result<Settings>(text.error());
  if (read.ok()) {
    last_ = editor->settings = read.value();
    for (const std::string& file : last_.opened_outside) editor->session().media().Allow(file);
  } else {
    const std::string aside = path_ + ".damaged";
    fs::rename(path_, aside, unknown);
    editor->Say(read.error().ToString() + "; the settings are the usual ones now, the file is " +
                    (unknown ? path_ : aside),
                true);
  }
  for (auto file = opened.rbegin(); file != opened.rend(); ++file) {
    AddRecent(*file, &editor->settings);
  }
}

void SettingsFile::SaveIfChanged(Editor* editor) {
  if (editor->settings == last_) return;
  last_ = editor->settings;
  std::error_code failed;
  fs::create_directories(fs::path(path_).parent_path(), failed);
  const Result<Done> written = WriteFileAtomically(path_, WriteSettings(last_));
  if (!written.ok()) editor->Say(written.error().ToString(), true);
}

}  // namespace hazumi::ui
