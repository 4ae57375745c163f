// SPDX-License-Identifier: GPL-3.0-or-later
// Reading whole files, and writing files that appear under their name only when they are finished.
#ifndef KINEX_EXPERIMENTS_FORMATS_FILE_IO_H
#define KINEX_EXPERIMENTS_FORMATS_FILE_IO_H

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinex::formats {

// Larger files are refused: they would be held in memory several times.
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

// The bytes of a regular file, or of standard input for "-". Throws InputError.
std::string read_file_bytes(const std::string& path);
// The same of a text: databases and compressed files are refused, and named as what they are.
std::string read_text_file(const std::string& path);
// The path is "-", or a link to standard output.
bool is_standard_output(const std::string& path);

// The treatment of an output that was not finished.
enum class Unfinished {
  kRemoved,
  kLinesKept,  // whole lines are useful: see OutputFile::keep_lines
};

// Writes to a temporary file beside `path`, PATH.partial-PID (PATH.partial-PID-1 if that is there); commit() renames it. An
// existing file is never replaced unless `force`; the new one has its permissions, and a link to it stays. Without commit() the
// temporary file is removed. Every failure throws InputError. If writing fails (a full disk) and lines are kept, the message
// names the file that has them.
// "-" and links to it (/dev/stdout), pipes, and links to files that the process has open (/dev/fd/3) get the text when the file
// is committed, or its whole lines when these are kept; a pipe is opened at once, and waits for its reader. Other devices
// (/dev/null) are written directly.
class OutputFile {
 public:
  OutputFile(std::string path, bool force, Unfinished unfinished = Unfinished::kRemoved);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  // Drops what was written, but for what a device has got already.
  void begin_again();
  void commit();
  // Closes the file, cut after its last whole line, as PATH.partial (or under its temporary name
  // where that is taken), and returns the name; empty if there was no line to keep.
  std::string keep_lines();
  const std::string& path() const { return path_; }
  // Temporary files of earlier runs for `path`: those runs were killed, or are still running.
  const std::vector<std::string>& leftovers() const { return leftovers_; }

 private:
  [[noreturn]] void fail(const char* what);
  void open_temporary();
  // Of a file without a name: copies `bytes` of it to stream_.
  void copy_to_stream(std::size_t bytes);

  std::string path_;
  std::string target_;                   // path_, or what it is a link to
  std::optional<unsigned> permissions_;  // of the file that is replaced
  std::string temporary_;  // empty: written directly, or a file without a name
  std::FILE* stream_ = nullptr;  // what gets the text of a file without a name
  bool force_;
  Unfinished unfinished_;
  std::vector<std::string> leftovers_;
  std::FILE* file_ = nullptr;
};

}  // namespace kinex::formats

#endif
