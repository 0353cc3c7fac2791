// A bundle into its folder, whole or not at all.
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "app/bundle/bundle.h"
#include "app/bundle/zip.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

base::Error failed(const std::string& folder, const std::error_code& reason) {
  return {base::ErrorCode::kIo, folder, {}, reason.message(), "a folder that can be written"};
}

/// Puts `made` in the place of `folder`; what was there goes.
base::Result<void> replace(const std::string& made, const std::string& folder) {
  const base::Exchange exchange;
  std::error_code error;
  const bool old = fs::exists(folder, error);
  const std::string aside = made + "-old";
  if (old) fs::rename(folder, aside, error);
  if (error) return tl::unexpected(failed(folder, error));
  fs::rename(made, folder, error);
  std::error_code ignored;
  if (error) {
    if (old) fs::rename(aside, folder, ignored);
    return tl::unexpected(failed(folder, error));
  }
  if (old) fs::remove_all(aside, ignored);
  base::syncFolderOf(folder);
  return {};
}

}  // namespace

base::Result<void> mayHoldBundle(const std::string& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored)) return {};
  const auto refused = [&folder](std::string found) {
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      folder,
                                      {},
                                      std::move(found),
                                      "a new or empty folder, or one with an earlier bundle and nothing else"});
  };
  if (!fs::is_directory(folder, ignored)) return refused("a file");
  const std::string path = folder + "/" + std::string(model_io::kManifestName);
  const auto text = base::readFile(path, std::size_t{4} << 20U);
  const auto manifest = text ? model_io::parseManifest(*text, path) : tl::unexpected(text.error());
  if (!manifest) return refused("a folder that holds other files");
  std::set<std::string> own = {std::string(model_io::kManifestName)};
  for (const model_io::BundleFile& file : manifest->files) own.insert(file.path);
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
    if (entry.is_directory(ignored)) continue;
    const std::string name = fs::relative(entry.path(), folder, ignored).generic_string();
    if (!own.contains(name)) return refused("a bundle with a file that is not its own, " + base::quoted(name));
  }
  return {};
}

base::Result<void> writeBundle(const Bundle& bundle, const std::string& folder_name, const std::stop_token& stop) {
  // Without a slash at its end, so that names beside it can be made.
  std::string folder = fs::path(folder_name).lexically_normal().string();
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  if (const auto ok = mayHoldBundle(folder); !ok) return ok;
  const fs::path parent = fs::path(folder).parent_path();
  if (!parent.empty()) {
    if (const auto made = base::makeFolder(parent.string()); !made) return made;
  }
  const base::Unfinished work = base::makeUnfinishedFolder(folder, base::kUnfinishedEnding);
  if (!work.descriptor.isOpen()) return tl::unexpected(failed(folder, {errno, std::generic_category()}));
  std::error_code ignored;
  for (const auto& [path, bytes] : bundle.files) {
    const std::string file = work.path + "/" + path;
    auto done = base::makeFolder(fs::path(file).parent_path().string());
    if (done) done = base::writeFileAtomically(file, bytes);
    if (done && stop.stop_requested())
      done = base::fail(base::ErrorCode::kCancelled, "bundle", "a request to stop", "time to end");
    if (!done) {
      fs::remove_all(work.path, ignored);
      return done;
    }
  }
  fs::permissions(work.path,
                  fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                      fs::perms::others_exec,
                  ignored);
  auto replaced = replace(work.path, folder);
  if (!replaced) fs::remove_all(work.path, ignored);
  return replaced;
}

base::Result<void> writeBundleZip(const Bundle& bundle, const std::string& file) {
  const fs::path path(file);
  const auto bytes = zipped(bundle.files, path.stem().string());
  if (!bytes) return base::inFile(bytes.error(), file);
  if (path.has_parent_path()) {
    if (const auto made = base::makeFolder(path.parent_path().string()); !made) return made;
  }
  return base::writeFileAtomically(file, *bytes);
}

}  // namespace tactus::bundle
