// Errors in outside input: one table of codes, one sentence per error.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace tactus::base {

/// Kinds of error. The command line returns exit status 1 for each; a C interface can return the number.
enum class ErrorCode {
  kIo = 1,          ///< a file or folder cannot be read or written
  kSyntax = 2,      ///< the text is not of its format (JSON, CSV, UTF-8)
  kSchema = 3,      ///< a key, column or table is missing, duplicate or of the wrong type
  kValue = 4,       ///< a value is outside its allowed range
  kReference = 5,   ///< a name refers to an object that does not exist
  kLimit = 6,       ///< a documented limit is exceeded
  kVersion = 7,     ///< the file is newer than this program
  kMismatch = 8,    ///< a verification result differs from the file
  kData = 9,        ///< the data do not determine a result
  kCancelled = 10,  ///< the caller canceled the operation
};

/// One text per code, understandable without context.
std::string_view describe(ErrorCode code) noexcept;

/// An error in outside input. The four texts make one sentence: `file: place: found …, wanted …`.
struct Error {
  ErrorCode code = ErrorCode::kValue;
  std::string file;    ///< file or folder, as named by the user; empty if there is none
  std::string place;   ///< line and column of a CSV file, pointer (RFC 6901) into a JSON file; may be empty
  std::string found;   ///< the actual content
  std::string wanted;  ///< the expected content

  /// The sentence, on one line, without a final newline.
  std::string message() const;
};

template <class T>
using Result = tl::expected<T, Error>;

#define TACTUS_TRY_JOIN_(a, b) a##b
#define TACTUS_TRY_NAME_(line) TACTUS_TRY_JOIN_(tried_, line)

/// `TACTUS_TRY(const auto model, readModel(path));` declares `model` as the value of the Result. The function around it
/// returns the error where there is none.
#define TACTUS_TRY(declaration, ...)                                                                     \
  auto TACTUS_TRY_NAME_(__LINE__) = (__VA_ARGS__);                                                       \
  if (!TACTUS_TRY_NAME_(__LINE__)) return tl::unexpected(std::move(TACTUS_TRY_NAME_(__LINE__)).error()); \
  declaration = *std::move(TACTUS_TRY_NAME_(__LINE__))

/// `tl::unexpected` of an error without a file. The layer that knows the file adds it with `inFile`.
tl::unexpected<Error> fail(ErrorCode code, std::string place, std::string found, std::string wanted);

/// The same error with the file name `file`. Keeps a file name that is already set.
tl::unexpected<Error> inFile(Error error, std::string_view file);

/// `text` with its control characters (isControl in text.h) and bytes that are not UTF-8 escaped: `\x1b` for a byte,
/// `\u202e` for a character. So it stays on one line and cannot send commands to a terminal. All outside text in a
/// message, including file names, passes through this function or `quoted`. A second call changes nothing.
std::string oneLine(std::string_view text);

/// The same for text of several lines; keeps the line ends.
std::string plainLines(std::string_view text);

/// Outside text in quotes for a message: escaped as in `oneLine`, cut to at most 60 bytes at a whole UTF-8 character.
std::string quoted(std::string_view text);

}  // namespace tactus::base
