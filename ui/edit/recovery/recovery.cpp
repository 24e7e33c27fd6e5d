#include "ui/edit/recovery/recovery.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "ui/edit/document/document.h"
#include "ui/edit/recovery/journal_format.h"
#include "ui/edit/recovery/locked_file.h"
#include "ui/edit/session/session_state.h"

namespace hazumi::edit {

// A relative path counts as none [XDG Base Directory Specification].
Result<std::string> StateFolder(const std::function<const char*(const char* name)>& variable) {
  const auto folder_in = [&](const char* name) {
    const char* value = variable(name);
    return value && value[0] == '/' ? std::string(value) : std::string();
  };
  const std::string state = folder_in("XDG_STATE_HOME");
  if (!state.empty()) return state + "/hazumi";
  const std::string home = folder_in("HOME");
  if (!home.empty()) return home + "/.local/state/hazumi";
  return Error{ErrorCode::kFailed, "", "XDG_STATE_HOME",
               "neither this nor HOME is the path of a folder, so that nothing can be kept safe "
               "from a crash; set one of them"};
}

namespace {

namespace fs = std::filesystem;
using SystemTime = std::chrono::system_clock::time_point;

std::optional<SystemTime> WrittenAt(const std::string& path) {
  struct stat status;
  if (path.empty() || ::stat(path.c_str(), &status) != 0) return std::nullopt;
  const auto since_epoch = std::chrono::seconds(status.st_mtim.tv_sec) +
                           std::chrono::nanoseconds(status.st_mtim.tv_nsec);
  return SystemTime(std::chrono::duration_cast<SystemTime::duration>(since_epoch));
}

Result<JournalText> ReadFrom(const LockedFile& file) {
  const Result<std::string> text = file.Read();
  if (!text.ok()) return text.error();
  return ReadJournal(text.value(), file.path());
}

AbandonedJournal Describe(const LockedFile& file) {
  AbandonedJournal journal;
  journal.file = file.path();
  journal.written = WrittenAt(file.path()).value_or(SystemTime());
  const Result<JournalText> text = ReadFrom(file);
  if (!text.ok()) {
    journal.damage = text.error();
    return journal;
  }
  journal.path = text.value().file.path;
  journal.num_operators = text.value().num_operators();
  journal.is_project_newer = WrittenAt(journal.path) > journal.written;
  return journal;
}

Error InLine(int number, Error error, const std::string& file) {
  return {error.code, file, "line " + std::to_string(number), error.ToString()};
}

// Does line by line what a journal says.
class Replay {
 public:
  // What succeeded once succeeds again, however long the motion that it needs takes.
  Replay(const JournalText& journal, Session* session)
      : journal_(journal), session_(session), patience_(session->patience()) {
    session_->set_patience(std::nullopt);
  }
  ~Replay() { session_->set_patience(patience_); }
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  Recovered Run(const std::string& file) {
    recovered_.is_cut_off = journal_.is_cut_off;
    for (const JournalLine& line : journal_.lines) {
      const Result<Done> done = Do(line);
      if (done.ok()) continue;
      recovered_.damage = InLine(line.number, done.error(), file);
      recovered_.damage->message += "; " + Account();
      break;
    }
    return recovered_;
  }

 private:
  Result<Done> Do(const JournalLine& line) {
    if (line.is_operator()) return DoOperator(line.json);
    if (line.json.contains("state")) return RestoreState(line.json["state"], session_);
    if (line.json.contains("digest")) return CheckDigest(line.json["digest"]);
    return Error{ErrorCode::kSyntax, "", "", "is damaged"};
  }

  Result<Done> DoOperator(Json parameters) {
    const Json id = parameters["op"];
    parameters.erase("op");
    if (!id.is_string() || id.get<std::string>().starts_with("file.")) {
      return Error{ErrorCode::kSchema, "", "",
                   "there is no operator " + id.dump() + " in journals"};
    }
    Result<Done> done = session_->Run(id.get<std::string>(), parameters);
    recovered_.num_operators += done.ok();
    return done;
  }

  Result<Done> CheckDigest(const Json& digest) {
    if (digest == DigestOf(WriteProject(session_->project()))) return Done();
    return Error{ErrorCode::kSchema, "", "",
                 "the project is not what it was here: a file that it uses changed, or another "
                 "version of Hazumi wrote the journal"};
  }

  std::string Account() const {
    return std::to_string(recovered_.num_operators) + " of " +
           std::to_string(journal_.num_operators()) +
           " operators were recovered; look at the project before you save it";
  }

  const JournalText& journal_;
  Session* session_;
  std::optional<double> patience_;
  Recovered recovered_;
};

// What a crash left of a journal before it had its name.
void RemoveUnfinished(const std::string& path) {
  Result<LockedFile> file = LockedFile::Open(path);
  if (file.ok()) (void)file.value().Remove();  // if it stays, it does no harm
}

}  // namespace

Result<std::vector<AbandonedJournal>> FindAbandonedJournals(const std::string& folder) {
  std::vector<AbandonedJournal> journals;
  std::error_code failed;
  if (!fs::exists(folder, failed) && !failed) return journals;
  std::vector<std::string> files;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    files.push_back(it->path().string());
  }
  if (failed) {
    return Error{ErrorCode::kNoInput, folder, "",
                 "the folder of journals cannot be read: " + failed.message()};
  }
  for (const std::string& path : files) {
    if (path.ends_with(".journal.new")) RemoveUnfinished(path);
    if (!path.ends_with(".journal")) continue;
    const Result<LockedFile> file = LockedFile::Open(path);
    if (file.ok()) journals.push_back(Describe(file.value()));
  }
  std::sort(journals.begin(), journals.end(),
            [](const auto& a, const auto& b) { return a.written > b.written; });
  return journals;
}

Result<Recovered> RecoverJournal(const std::string& path, Session* session) {
  const Result<LockedFile> file = LockedFile::Open(path);
  if (!file.ok()) return file.error();
  const Result<JournalText> journal = ReadFrom(file.value());
  if (!journal.ok()) return journal.error();
  Result<Project> base = ParseProject(journal.value().base, journal.value().file.path);
  if (!base.ok()) return InLine(2, base.error(), path);
  session->Replace(std::move(base).value(), journal.value().file.path);
  Document& document = session->document();
  document.set_file_digest(journal.value().file.digest);
  document.MarkUnsaved();
  // What could be undone when it was written can be undone now.
  const size_t limit = document.history_limit();
  document.set_history_limit(std::numeric_limits<size_t>::max());
  const Recovered recovered = Replay(journal.value(), session).Run(path);
  document.EndMerge();
  document.set_history_limit(limit);
  return recovered;
}

Result<Done> DiscardJournal(const std::string& path) {
  Result<LockedFile> file = LockedFile::Open(path);
  return file.ok() ? file.value().Remove() : file.error();
}

}  // namespace hazumi::edit
