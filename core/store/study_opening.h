// Opens a study file: checks before its contents are trusted, and messages about its last opening. Private to
// core/store.
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

/// See StudyFile::open.
base::Result<OpenedStudy> openStudy(const std::string& path, const OpenOptions& options);

/// A connection to `path`, or an error with one sentence.
base::Result<std::unique_ptr<Connection>> connect(const std::string& path, Connection::Mode mode,
                                                  const std::string& vfs);

}  // namespace tactus::store
