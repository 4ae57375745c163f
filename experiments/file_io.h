// SPDX-License-Identifier: GPL-3.0-or-later
// Reading whole files, and writing files that appear under their name only when they are finished.
#ifndef KINEX_EXPERIMENTS_FILE_IO_H
#define KINEX_EXPERIMENTS_FILE_IO_H

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace kinex {

// Files beyond this are refused: they would be held in memory several times.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

// The bytes of a regular file, or of standard input for "-". Throws InputError.
std::string read_text_file(const std::string& path);

// Writes to a temporary file beside `path`; commit() gives it its name. A file that exists is never
// replaced unless `force`. Devices (/dev/null) are written directly. Without commit() the temporary
// file is removed. Every failure throws InputError.
class OutputFile {
 public:
  OutputFile(std::string path, bool force);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  void commit();
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  std::string temporary_;  // empty: written directly
  bool force_;
  std::FILE* file_ = nullptr;
};

}  // namespace kinex

#endif
