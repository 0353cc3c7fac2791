#include "app/dataset/published_study.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/base/files/descriptor.h"
#include "core/base/files/file.h"

namespace tactus::dataset {
namespace {

constexpr std::string_view kName = "Forces of nasogastric tube insertion as experts feel them";
constexpr std::string_view kMeasured =
    "Insertion strokes at speeds that were asked for, forces judged in words, answers about the force in each "
    "situation, and rules given directly, for a force model of nasogastric tube insertion.";
constexpr std::string_view kLeftOut =
    "Only what counts is here: no practice, no stroke that was not accepted, no judgement that is not scored, no "
    "corrected record. Participants have new codes in a random order. Years of experience are bands. Dates, times of "
    "day, places, names of devices and notes are left out, and so are categories and hands in other than the usual "
    "words. With "
    "few participants a rare combination may still tell who somebody is: look at the table of participants before the "
    "data set is published.";
constexpr std::string_view kToEnter =
    "Before the data set is published, enter its authors and its license in dataset_description.json.";

tl::unexpected<base::Error> refused(const std::string& path, std::string wanted) {
  return tl::unexpected(
      base::Error{base::ErrorCode::kIo, path, {}, std::generic_category().message(errno), std::move(wanted)});
}

}  // namespace

std::string PublishedStudy::name() const {
  return std::string(kName) + (simulated.empty() ? "" : " (with simulated data)") +
         (without_force.empty() ? "" : " (VIRTUAL)");
}

std::string PublishedStudy::description() const {
  return std::string(kMeasured) + (simulated.empty() ? "" : " " + simulated) +
         (without_force.empty() ? "" : " " + without_force);
}

std::string PublishedStudy::readme(std::string_view layout) const {
  std::string text = name() + "\n\n";
  if (!simulated.empty()) text += simulated + "\n\n";
  if (!without_force.empty()) text += without_force + "\n\n";
  text += std::string(kMeasured) + "\n\n" + std::string(layout) + "\n\n";
  text += std::string(kLeftOut) + "\n\n" + std::string(kToEnter) + "\n\nWritten by " + version + ".\n";
  return text;
}

PublishedStudy publishedStudy(const study::Study& study, std::uint64_t seed, std::string_view version) {
  session::ShareableStudy shared = session::shareable(study, seed);
  std::string without_force = session::virtualNote(shared.study);
  return {std::move(shared), session::inputsOf(study), session::simulatedNote(study), std::move(without_force),
          std::string(version)};
}

void FileSet::add(std::string_view below, std::string_view text) {
  if (!state_) return;
  const auto path = std::filesystem::path(folder_) / below;
  state_ = base::makeFolder(path.parent_path().string());
  if (!state_) return;
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) state_ = refused(path.string(), "a file that can be written");
  ++files_;
}

base::Result<std::size_t> FileSet::finish() const {
  if (!state_) return tl::unexpected(state_.error());
  const base::Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.isOpen() || ::syncfs(folder.number()) != 0) return refused(folder_, "a folder that can be written");
  return files_;
}

}  // namespace tactus::dataset
