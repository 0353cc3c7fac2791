// second_writer STUDY [VFS]: another program that writes to a study. It says `opening`, opens, says `open`, writes an
// answer at a line of its input and says `written`, and closes at the next. Where something fails it says why and ends
// with 1. With the VFS `plain` it is a program that knows SQLite alone: it says whether it may write.
#include <cstdio>
#include <sqlite3.h>
#include <string>

#include "core/store/entries.h"
#include "core/store/sessions.h"
#include "core/store/study_file.h"

#include "tests/core/store/sample_records.h"

namespace {

void say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

int fail(const std::string& line) {
  say(line);
  return 1;
}

int plain(const char* path) {
  sqlite3* database = nullptr;
  if (sqlite3_open_v2(path, &database, SQLITE_OPEN_READWRITE, nullptr) != SQLITE_OK) return fail("does not open");
  const int code =
      sqlite3_exec(database, "PRAGMA locking_mode = EXCLUSIVE; BEGIN IMMEDIATE; ROLLBACK", nullptr, nullptr, nullptr);
  if (code == SQLITE_BUSY) say("busy");  // nothing is closed: the process ends
  return code == SQLITE_BUSY ? 0 : fail("may write");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tactus;
  if (argc < 2) return 2;
  const std::string vfs = argc > 2 ? argv[2] : "";
  if (vfs == "plain") return plain(argv[1]);
  say("opening");
  auto study = store::StudyFile::open(argv[1], {store::Access::kReadWrite, vfs});
  if (!study) return fail(study.error().message());
  say("open");
  std::getchar();
  const auto sessions = store::sessions(*study);
  if (!sessions || sessions->empty()) return fail("no session");
  store::SampleRecords records(77);
  const auto written = append(*study, records.answer(sessions->front().id));
  if (!written) return fail(written.error().message());
  say("written");
  std::getchar();
  const auto closed = study->close();
  return closed ? 0 : fail(closed.error().message());
}
