#include "app/dataset/dataset.h"

#include "app/dataset/bids.h"
#include "app/dataset/psych_ds.h"
#include "app/dataset/published_study.h"
#include "app/session/export_folder.h"

namespace tactus::dataset {

base::Result<DataSet> writeDataSet(const study::Study& study, Layout layout, const std::string& folder,
                                   std::uint64_t seed, std::string_view version) {
  if (study.participants.empty()) {
    return tl::unexpected(base::Error{base::ErrorCode::kData, study.name, {}, "no participant", "at least one"});
  }
  auto place = session::ExportFolder::beside(folder, layout == Layout::kBids ? bidsExport() : psychDsExport());
  if (!place) return tl::unexpected(place.error());
  const auto removed = session::removeOurs(session::leftoversOfExport(folder));
  const PublishedStudy published = publishedStudy(study, seed, version);
  FileSet files(place->path());
  DataSet done;
  done.participants = study.participants.size();
  if (layout == Layout::kBids) {
    done.notes = writeBids(published, files);
  } else if (auto ok = writePsychDs(published, place->path(), files); !ok) {
    return tl::unexpected(ok.error());
  }
  const auto written = files.finish();
  if (!written) return tl::unexpected(written.error());
  done.files = *written;
  if (auto placed = place->place(); !placed) return tl::unexpected(placed.error());
  for (const auto& path : removed) done.notes.push_back(path + ": left by a crash; deleted");
  return done;
}

}  // namespace tactus::dataset
