// store_kill_child STUDY SESSION: writes records into the session on and on and says each number on standard output
// once it is acknowledged. Made to be killed.
#include <iostream>
#include <unistd.h>

#include "tests/core/store/disk_script.h"

int main(int argc, char** argv) {
  using namespace tactus;
  if (argc != 3) return 2;
  const auto session = study::parseRecordId(argv[2]);
  auto file = store::StudyFile::open(argv[1]);
  if (!session || !file) {
    std::cerr << (file ? "no session" : file.error().message()) << '\n';
    return 1;
  }
  const store::DiskScript script(*session);
  std::string complaint;
  for (int number = script.intactRecords(*file, complaint);; ++number) {
    const auto written = script.write(*file, number);
    if (!written || !complaint.empty()) {
      std::cerr << (written ? complaint : written.error().message()) << '\n';
      return 1;
    }
    if (::write(STDOUT_FILENO, &number, sizeof number) != sizeof number) return 1;
  }
}
