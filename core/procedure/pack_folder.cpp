#include <filesystem>
#include <mutex>
#include <utility>

#include "core/base/check.h"
#include "core/base/files/file.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {

// Embedded from packs/: the files of all packs, by their path below it.
std::vector<std::pair<std::string_view, std::string_view>> embeddedPacks();

namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::Result;

constexpr std::string_view kDefaultId = "nasogastric-tube";
constexpr std::size_t kMostFiles = 500;

Result<PackFiles> filesOf(const std::string& folder) {
  PackFiles files;
  std::size_t all = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->is_directory(error)) continue;
    const std::string path = it->path().string();
    if (auto ok = base::requireBelow(folder, path); !ok) return tl::unexpected(std::move(ok).error());
    TACTUS_TRY(auto bytes, base::readFile(path, kMostFileBytes));
    all += bytes.size();
    if (all > kMostPackBytes || files.size() >= kMostFiles) {
      return base::inFile(
          {ErrorCode::kLimit, {}, {}, "more than 16 MiB or 500 files", "a pack: procedure.json and what it names"},
          folder);
    }
    files.emplace(it->path().lexically_relative(folder).generic_string(), std::move(bytes));
  }
  if (error) return base::inFile({ErrorCode::kIo, {}, {}, error.message(), "a folder that can be read"}, folder);
  return files;
}

/// The packs that the program carries, read once.
const std::vector<std::shared_ptr<const Procedure>>& builtInPacks() {
  static const auto packs = [] {
    std::map<std::string, PackFiles> by_pack;
    for (const auto& [path, bytes] : embeddedPacks()) {
      const auto slash = path.find('/');
      by_pack[std::string(path.substr(0, slash))].emplace(path.substr(slash + 1), bytes);
    }
    std::vector<std::shared_ptr<const Procedure>> out;
    for (auto& [name, files] : by_pack) {
      auto read = readProcedure(std::move(files), name);
      TACTUS_CHECK(read.has_value());
      const bool first = read->id == kDefaultId;
      out.insert(first ? out.begin() : out.end(), std::make_shared<const Procedure>(*std::move(read)));
    }
    TACTUS_CHECK(!out.empty() && out.front()->id == kDefaultId);
    return out;
  }();
  return packs;
}

}  // namespace

Result<Procedure> readPackFolder(const std::string& path) {
  TACTUS_TRY(auto files, filesOf(path));
  return readProcedure(std::move(files), path);
}

std::vector<std::string> builtInIds() {
  std::vector<std::string> out;
  for (const auto& pack : builtInPacks()) out.push_back(pack->id);
  return out;
}

std::shared_ptr<const Procedure> builtIn(std::string_view id) {
  for (const auto& pack : builtInPacks()) {
    if (pack->id == id) return pack;
  }
  return nullptr;
}

const std::shared_ptr<const Procedure>& defaultProcedure() { return builtInPacks().front(); }

}  // namespace tactus::procedure
