// What can go wrong with outside input: one table of codes, one sentence per error.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace tactus::base {

/// Kinds of error. The command line turns every one of them into exit status 1; a C interface can pass the number on.
enum class ErrorCode {
  kIo = 1,          ///< a file or folder cannot be read or written
  kSyntax = 2,      ///< the text is not of its format (JSON, CSV, UTF-8)
  kSchema = 3,      ///< a key, column or table is missing, doubled or of the wrong type
  kValue = 4,       ///< a value is outside what its place allows
  kReference = 5,   ///< a name refers to nothing
  kLimit = 6,       ///< a documented limit is exceeded
  kVersion = 7,     ///< the file is newer than this program
  kMismatch = 8,    ///< a verification gave another result than the file says
  kData = 9,        ///< the data do not determine an answer
  kCancelled = 10,  ///< the caller stopped it before the end
};

/// One text per code, for a reader who knows nothing else.
std::string_view describe(ErrorCode code) noexcept;

/// An error in outside input. The four texts make one sentence: `file: place: found …, wanted …`.
struct Error {
  ErrorCode code = ErrorCode::kValue;
  std::string file;    ///< file or folder, as the person named it; empty when there is none
  std::string place;   ///< line and column of a CSV file, pointer (RFC 6901) into a JSON file; may be empty
  std::string found;   ///< what is there
  std::string wanted;  ///< what should be there

  /// The sentence, on one line, without a final newline.
  std::string message() const;
};

template <class T>
using Result = tl::expected<T, Error>;

/// `tl::unexpected` of an error without a file, which the layer that knows the file adds with `inFile`.
tl::unexpected<Error> fail(ErrorCode code, std::string place, std::string found, std::string wanted);

/// The same error, said of `file`. A file that is named already stays.
tl::unexpected<Error> inFile(Error error, std::string_view file);

/// `text` with its control characters (isControl in text.h) and bytes that are no UTF-8 escaped, so that it stays on
/// one line and gives no orders to a terminal: `\x1b` for a byte, `\u202e` for a character. All outside text of a
/// message, file names too, goes through this function or `quoted`. Doing it twice changes nothing.
std::string oneLine(std::string_view text);

/// The same for text of several lines, which keeps its ends of lines.
std::string plainLines(std::string_view text);

/// Outside text in quotes for a message: as `oneLine`, at most 60 bytes of it, cut at a whole UTF-8 character.
std::string quoted(std::string_view text);

}  // namespace tactus::base
