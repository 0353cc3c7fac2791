// The way into a study file: what is looked at before it is believed, and what is said of its last opening.
// Private to core/store.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/store/connection.h"
#include "core/store/study_file.h"

namespace tactus::store {

struct OpenedStudy {
  std::unique_ptr<Connection> connection;
  int version = 0;
  std::vector<Notice> notices;  ///< StudyFile::notices
};

/// As StudyFile::open.
base::Result<OpenedStudy> openStudy(const std::string& path, const OpenOptions& options);

/// A connection to `path`, or the error in a sentence.
base::Result<std::unique_ptr<Connection>> connect(const std::string& path, Connection::Mode mode,
                                                  const std::string& vfs);

}  // namespace tactus::store
