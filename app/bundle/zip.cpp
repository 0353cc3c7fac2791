#include "app/bundle/zip.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <system_error>
#include <zip.h>

#include "core/base/files/file.h"
#include "core/base/text.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

constexpr zip_int64_t kMostFiles = 10'000;
constexpr std::uint64_t kMostUnpackedBytes = std::uint64_t{1} << 30U;

// Attributes as Unix programs read them.
constexpr std::uint32_t kFileKind = 0100000;
constexpr std::uint32_t kKindMask = 0170000;
constexpr std::uint32_t kUsualFile = kFileKind | 0644U;
constexpr unsigned kModeShift = 16;

// The first day of the format: the time of the files would make each zip another one.
constexpr std::uint16_t kFirstDay = (1U << 5U) | 1U;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

base::Error failed(const std::string& path, std::string found, std::string wanted) {
  return {base::ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)};
}

/// Adds one file, whose bytes must outlive the archive.
bool add(zip_t* archive, const std::string& path, const std::string& bytes) {
  zip_source_t* const source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) return false;
  const zip_int64_t index = zip_file_add(archive, path.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto file = static_cast<zip_uint64_t>(index);
  return zip_file_set_dostime(archive, file, 0, kFirstDay, 0) == 0 &&
         zip_file_set_external_attributes(archive, file, 0, ZIP_OPSYS_UNIX, kUsualFile << kModeShift) == 0;
}

/// The whole of a source that an archive has been written to.
base::Result<std::string> bytesOf(zip_source_t* source) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) {
    return tl::unexpected(failed("zip", zip_error_strerror(zip_source_error(source)), "a zip file in memory"));
  }
  std::string bytes(stat.size, '\0');
  const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (got != static_cast<zip_int64_t>(bytes.size())) {
    return tl::unexpected(failed("zip", "fewer bytes than were written", "a zip file in memory"));
  }
  return bytes;
}

/// Whether a file of that name stays below the folder that it is unpacked into.
bool staysBelow(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.find('\\') != std::string_view::npos ||
      name.find('\0') != std::string_view::npos) {
    return false;
  }
  const fs::path path(name);
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".." || part == "."; });
}

bool isUsualFile(zip_t* archive, zip_uint64_t index) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) != 0) return false;
  const std::uint32_t kind = (attributes >> kModeShift) & kKindMask;
  return system != ZIP_OPSYS_UNIX || kind == 0 || kind == kFileKind;
}

void dropCommonFolder(PackedFiles& files) {
  if (files.empty()) return;
  const std::size_t end = files.front().first.find('/');
  if (end == std::string::npos) return;
  const std::string folder = files.front().first.substr(0, end + 1);
  if (!std::all_of(files.begin(), files.end(), [&](const auto& file) { return file.first.starts_with(folder); }))
    return;
  for (auto& file : files) file.first.erase(0, folder.size());
}

}  // namespace

bool isZipName(std::string_view path) { return base::lowered(fs::path(path).extension().string()) == ".zip"; }

base::Result<std::string> zipped(const PackedFiles& files, const std::string& folder) {
  zip_error_t error;
  zip_error_init(&error);
  const Source source(zip_source_buffer_create(nullptr, 0, 0, &error));
  Archive archive(source ? zip_open_from_source(source.get(), ZIP_TRUNCATE, &error) : nullptr);
  const auto said = [&](const char* words) { return tl::unexpected(failed("zip", words, "memory for a zip file")); };
  if (!archive) return said(zip_error_strerror(&error));
  zip_source_keep(source.get());
  for (const auto& [path, bytes] : files) {
    if (!add(archive.get(), folder.empty() ? path : folder + "/" + path, bytes))
      return said(zip_strerror(archive.get()));
  }
  if (zip_close(archive.get()) != 0) return said(zip_strerror(archive.get()));
  archive.release();
  return bytesOf(source.get());
}

base::Result<PackedFiles> unzipped(const std::string& path) {
  int code = 0;
  const Archive archive(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    auto refused = failed(path, zip_error_strerror(&error), "a zip file");
    zip_error_fini(&error);
    return tl::unexpected(std::move(refused));
  }
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count > kMostFiles) {
    return tl::unexpected(failed(path, std::to_string(count) + " files", "at most " + std::to_string(kMostFiles)));
  }
  PackedFiles files;
  std::uint64_t all = 0;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive.get(), i, 0, &stat) != 0)
      return tl::unexpected(failed(path, zip_strerror(archive.get()), "a whole zip file"));
    const std::string name = stat.name;
    if (name.ends_with('/')) continue;  // a folder
    if (!staysBelow(name) || !isUsualFile(archive.get(), i))
      return tl::unexpected(failed(path, base::quoted(name), "files below one folder, and no links"));
    all += stat.size;
    if (all > kMostUnpackedBytes) return tl::unexpected(failed(path, "files of more than 1 GiB", "at most 1 GiB"));
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive.get(), i, 0));
    std::string bytes(stat.size, '\0');
    if (!file || zip_fread(file.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()))
      return tl::unexpected(failed(path, base::quoted(name) + " that cannot be unpacked", "a whole zip file"));
    files.emplace_back(name, std::move(bytes));
  }
  dropCommonFolder(files);
  return files;
}

base::Result<UnzippedFolder> UnzippedFolder::of(const std::string& path) {
  namespace fs = std::filesystem;
  TACTUS_TRY(const auto files, unzipped(path));
  std::error_code ignored;
  const fs::path place = fs::temp_directory_path(ignored) / "tactus-unzipped";
  UnzippedFolder out(path, base::makeUnfinishedFolder(place.string(), base::kUnfinishedEnding));
  if (!out.folder_.descriptor.isOpen())
    return base::fail(base::ErrorCode::kIo, place.string(), "no place to unpack", "a folder for temporary files");
  for (const auto& [name, bytes] : files) {
    const std::string file = out.path() + "/" + name;
    if (auto ok = base::makeFolder(fs::path(file).parent_path().string()); !ok)
      return tl::unexpected(std::move(ok).error());
    if (auto ok = base::writeFileAtomically(file, bytes); !ok) return tl::unexpected(std::move(ok).error());
  }
  return out;
}

std::string UnzippedFolder::named(std::string text) const {
  return base::replaced(std::move(text), {{folder_.path, zip_}});
}

base::Error UnzippedFolder::named(base::Error error) const {
  error.file = named(std::move(error.file));
  return error;
}

UnzippedFolder::UnzippedFolder(UnzippedFolder&& other) noexcept
    : zip_(std::move(other.zip_)), folder_(std::move(other.folder_)) {
  other.folder_.path.clear();
}

UnzippedFolder::~UnzippedFolder() {
  std::error_code ignored;
  if (!folder_.path.empty()) std::filesystem::remove_all(folder_.path, ignored);
}

}  // namespace tactus::bundle
