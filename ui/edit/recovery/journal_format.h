#pragma once

// Internal. A journal's text: one JSON object a line.
//   {"journal": 1, "path": "/home/me/jump.kfa",    of the document; empty: it has no file
//    "file": "<16 hexadecimal digits>"}            what it held when it was read or saved, if known
//   {"base": "<.kfa text>"}                        from where the rest replays
// and then, in any order,
//   {"state": {...}}                               of session_state.h, from here on
//   {"op": "key.set", "curve": "r_knee", ...}      as in scripts
//   {"digest": "<16 hexadecimal digits>"}          of the document as it is here
// A last line without its end was cut off by the crash and is no part of it.

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "ui/edit/parameters.h"

namespace hazumi::edit {

struct DocumentFile {
  std::string path;    // absolute or empty
  std::string digest;  // Document::file_digest
};
std::string JournalHead(const DocumentFile& file, const std::string& base, const Json& state);
std::string StateLine(const Json& state);
std::string OperatorLine(const std::string& id, const Json& parameters);
std::string DigestLine(std::string_view text);

struct JournalLine {
  int number;  // from 1
  Json json;   // null: cannot be read
  bool is_operator() const { return json.is_object() && json.contains("op"); }
};

struct JournalText {
  DocumentFile file;
  std::string base;
  std::vector<JournalLine> lines;  // after the base
  bool is_cut_off = false;         // a last line had no end
  int num_operators() const;
};

// Errors: kSyntax and kSchema, of head and base, the place being the line.
Result<JournalText> ReadJournal(std::string_view text, const std::string& file);

}  // namespace hazumi::edit
