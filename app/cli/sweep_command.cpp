#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "app/cli/cell_pictures.h"
#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/sweep_sheet.h"
#include "app/cli/terminal.h"
#include "engine/base/memory.h"
#include "engine/base/version.h"
#include "engine/project/address/all_addresses.h"
#include "engine/project/json/text_file.h"
#include "engine/project/project_reader.h"
#include "engine/sweep/sweep_run.h"
#include "engine/sweep/sweep_store.h"
#include "engine/sweep/table_text.h"

namespace hazumi {

namespace {

// Blocks of cells, done by some threads at a time.
class BlockRun {
 public:
  BlockRun(const Sweep& sweep, const SweepStore& store, std::vector<long> blocks, bool open_outside)
      : sweep_(sweep),
        store_(store),
        blocks_(std::move(blocks)),
        open_outside_(open_outside),
        progress_("sweep", static_cast<int>(blocks_.size())) {}

  std::optional<Error> Run() {
    const size_t wanted = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    for (size_t i = 1; i < std::min(wanted, blocks_.size()); ++i) {
      threads.emplace_back([this] { Work(); });
    }
    Work();
    for (std::thread& thread : threads) thread.join();
    progress_.Finish();
    return error_;
  }

 private:
  void Work() {
    const Result<Done> done = WithinMemory([&]() -> Result<Done> { return DoBlocks(); });
    if (!done.ok()) Fail(done.error());
  }

  Result<Done> DoBlocks() {
    std::optional<CellPictures> pictures;
    if (sweep_.plan().picture) {
      Result<CellPictures> made = CellPictures::Create(sweep_, store_, open_outside_);
      if (!made.ok()) return made.error();
      pictures.emplace(std::move(made).value());
    }
    while (!has_failed_) {
      const size_t next = next_++;
      if (next >= blocks_.size()) break;
      Result<Done> done = DoBlock(blocks_[next], pictures ? &*pictures : nullptr);
      if (!done.ok()) return done;
      Report(blocks_[next]);
    }
    return Done();
  }

  Result<Done> DoBlock(long block, CellPictures* pictures) {
    Sweep::Draw draw;
    if (pictures) draw = [&](const SweptCell& cell) { return pictures->Draw(cell); };
    std::string rows;
    for (long cell = store_.FirstCell(block); cell < store_.EndCell(block); ++cell) {
      const Result<std::string> row = sweep_.RowOf(cell, draw, &Interrupted());
      if (Interrupted()) return InterruptedError();
      if (!row.ok()) return row.error();
      rows += row.value();
      if (has_failed_) return Done();
    }
    return store_.WriteBlock(block, rows);
  }

  void Report(long block) {
    const std::lock_guard lock(mutex_);
    progress_.Report(++done_, "cells " + std::to_string(store_.FirstCell(block)) + ".." +
                                  std::to_string(store_.EndCell(block) - 1));
  }

  void Fail(const Error& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
    has_failed_ = true;
  }

  const Sweep& sweep_;
  const SweepStore& store_;
  const std::vector<long> blocks_;
  const bool open_outside_;
  Progress progress_;
  std::atomic<size_t> next_ = 0;
  std::atomic<bool> has_failed_ = false;
  std::mutex mutex_;
  int done_ = 0;
  std::optional<Error> error_;
};

// Blocks that are not there yet; of several tasks, those of this one's share.
std::vector<long> MissingBlocks(const SweepStore& store, const Options& options) {
  std::vector<long> missing;
  for (long block = 0; block < store.blocks(); ++block) {
    if (options.tasks > 0 && block % options.tasks != options.task_number) continue;
    if (!store.HasBlock(block)) missing.push_back(block);
  }
  return missing;
}

// How many failed, and the first of them.
void PrintFailures(const Rows& rows) {
  long failed = 0;
  const std::vector<std::string>* first = nullptr;
  for (size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].back().empty()) continue;
    ++failed;
    if (!first) first = &rows[i];
  }
  if (!first) return;
  PrintLine(stderr, "hazumi: warning: %ld of %zu cells failed; cell %s: %s", failed,
            rows.size() - 1, first->front().c_str(), first->back().c_str());
}

int Merge(const Sweep& sweep, const SweepStore& store) {
  const Result<Done> merged = store.Merge(sweep.Header());
  if (!merged.ok()) return Complain(merged.error());
  const Result<std::string> csv = ReadTextFile(store.CsvPath());
  if (!csv.ok()) return Complain(csv.error());
  const Rows rows = ReadCsv(csv.value());
  PrintFailures(rows);
  const Result<bool> drawn = WriteSweepSheet(sweep, store, rows);
  if (!drawn.ok()) return Complain(drawn.error());
  PrintLine(stdout, "%s: %zu cells", store.CsvPath().c_str(), rows.size() - 1);
  if (drawn.value()) PrintLine(stdout, "%s", store.SheetPath().c_str());
  return kExitOk;
}

}  // namespace

int RunSweep(const Options& options) {
  const Result<Sweep> loaded = Sweep::Load(options.script);
  if (!loaded.ok()) return Complain(loaded.error());
  const Sweep& sweep = loaded.value();
  PrintWarnings(options.script, sweep.plan().read.warnings);
  if (options.count) {
    PrintLine(stdout, "%ld", sweep.cells());
    return kExitOk;
  }
  if (sweep.plan().picture) {
    const Result<Done> checked = CellPictures::Check(sweep, options.open_outside);
    if (!checked.ok()) return Complain(InFile(checked.error(), options.script));
  }
  const auto store =
      SweepStore::Open(options.output, sweep.cells(), sweep.Identity("Hazumi " + ProgramVersion()));
  if (!store.ok()) return Complain(store.error());
  BlockRun run(sweep, store.value(), MissingBlocks(store.value(), options), options.open_outside);
  if (auto error = run.Run()) return Complain(*error);
  return options.tasks > 0 ? kExitOk : Merge(sweep, store.value());
}

int RunFields(const Options& options) {
  const Result<Project> project = LoadProject(options.files[0]);
  if (!project.ok()) return Complain(project.error());
  for (const ListedField& field : ListFields(project.value())) {
    PrintLine(stdout, "%s = %s", field.address.c_str(), field.json.c_str());
  }
  return kExitOk;
}

int RunQuantities() {
  for (const Quantity& quantity : AllQuantities()) {
    PrintLine(stdout, "%-20s %s%s", quantity.name, quantity.help,
              quantity.is_at_frame ? " (\"frame\")" : "");
  }
  return kExitOk;
}

}  // namespace hazumi
