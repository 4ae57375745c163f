// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/file_io.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "experiments/formats/input_error.h"

namespace kinex::formats {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

InputError cannot_read(const std::string& path, const std::string& why, const char* remedy) {
  return InputError(path, "", "cannot be read: " + why, remedy);
}

// Files that are taken for texts by their names.
void refuse_binary(std::string_view text, const std::string& path) {
  static constexpr const char* kUnpack = "unpack it, and give the file that was packed";
  struct Form {
    std::string_view begin, what;
    const char* remedy;
  };
  static constexpr Form kForms[] = {
      {"SQLite format 3", "a SQLite database, not a text",
       "sqlite3 and experiments/python/kinex_results.py read what is in it"},
      {"\x1f\x8b", "compressed by gzip", kUnpack},
      {"\xfd"
       "7zXZ",
       "compressed by xz", kUnpack},
      {"\x28\xb5\x2f\xfd", "compressed by zstd", kUnpack},
      {"BZh", "compressed by bzip2", kUnpack},
      {"PK\x03\x04", "a zip archive", kUnpack}};
  for (const Form& form : kForms) {
    if (text.starts_with(form.begin)) {
      throw InputError(path, "", "it is " + std::string(form.what), form.remedy);
    }
  }
}

void refuse_existing(const std::string& path) {
  throw InputError(path, "", "exists already", "give another name, or --force to replace it");
}

// "PATH.partial", "PATH.partial-PID" and "PATH.partial-PID-1"; sorted.
std::vector<std::string> partial_files(const std::string& path) {
  const fs::path whole(path);
  const std::string folder = whole.parent_path().string();
  const std::string begin = whole.filename().string() + ".partial";
  std::vector<std::string> found;
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(begin)) continue;
    const std::string rest = name.substr(begin.size());
    if (!rest.empty() && (rest.size() < 2 || rest[0] != '-' ||
                          rest.find_first_not_of("0123456789-", 1) != std::string::npos)) {
      continue;
    }
    found.push_back((folder.empty() ? fs::path(name) : fs::path(folder) / name).string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The number of bytes up to and including the last newline; 0 if there is none.
std::size_t end_of_last_line(std::FILE* file) {
  if (std::fseek(file, 0, SEEK_END) != 0) return 0;
  const long bytes = std::ftell(file);
  std::size_t size = bytes < 0 ? 0 : static_cast<std::size_t>(bytes);
  char block[4096];
  while (size > 0) {
    const std::size_t from = size - std::min(size, sizeof block);
    if (std::fseek(file, static_cast<long>(from), SEEK_SET) != 0 ||
        std::fread(block, 1, size - from, file) != size - from) {
      return 0;
    }
    for (std::size_t i = size - from; i > 0; --i) {
      if (block[i - 1] == '\n') return from + i;
    }
    size = from;
  }
  return 0;
}

// Cuts the file after its last newline; false if there is none.
bool cut_after_last_line(const std::string& path) {
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  const std::size_t end = file ? end_of_last_line(file.get()) : 0;
  if (end == 0) return false;
  std::error_code error;
  fs::resize_file(path, end, error);
  return !error;
}

// The number of an open file of a process that the path is a link to: "1" for /dev/stdout. Empty: none.
std::string open_file(fs::path path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const fs::path folder =
        fs::canonical(path.has_parent_path() ? path.parent_path() : fs::path("."), error);
    if (error) break;
    const std::string name = folder.string();
    if (name.starts_with("/proc/") && name.ends_with("/fd")) return path.filename().string();
    path = folder / fs::read_symlink(path, error);
  }
  return "";
}

// False if the path leads to a file that this process has open, by open_file's number, in no mode for it: opened anew, it
// would be /dev/null for the standard streams that the program was started without.
bool is_open_for(const std::string& number, int forbidden) {
  int file = 0;
  const char* const end = number.data() + number.size();
  const std::from_chars_result read = std::from_chars(number.data(), end, file);
  if (read.ec != std::errc() || read.ptr != end) return true;
  const int mode = ::fcntl(file, F_GETFL);
  return mode == -1 || (mode & O_ACCMODE) != forbidden;
}

// Opens a pipe with a name for writing, when it has a reader. nullptr, and errno: a signal that is handled has come (open()
// itself would go on after it), or it cannot be opened.
std::FILE* open_pipe(const std::string& path) {
  constexpr int kWait = 20;  // milliseconds between two looks
  int file = -1;
  while ((file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC)) < 0) {
    if (errno != ENXIO || ::poll(nullptr, 0, kWait) < 0) return nullptr;
  }
  ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return ::fdopen(file, "wb");
}

}  // namespace

bool is_standard_output(const std::string& path) { return path == "-" || open_file(path) == "1"; }

std::string read_file_bytes(const std::string& path) {
  const bool standard_input = path == "-";
  std::error_code error;
  if (!standard_input && fs::is_directory(path, error)) {
    throw cannot_read(path, "it is a directory", "give a file");
  }
  if (!standard_input && !is_open_for(open_file(path), O_WRONLY)) {
    throw cannot_read(path, std::strerror(EBADF), "check the name and its permissions");
  }
  std::unique_ptr<std::FILE, CloseFile> owned;
  if (!standard_input) {
    owned.reset(std::fopen(path.c_str(), "rb"));
    if (!owned) throw cannot_read(path, std::strerror(errno), "check the name and its permissions");
  }
  std::FILE* file = standard_input ? stdin : owned.get();
  std::string text;
  const std::uintmax_t expected = standard_input ? 0 : fs::file_size(path, error);
  if (!error && expected <= kMaxFileBytes) text.reserve(expected + 1);
  char buffer[1 << 16];
  std::size_t got = 0;
  while ((got = std::fread(buffer, 1, sizeof buffer, file)) > 0) {
    text.append(buffer, got);
    if (text.size() > kMaxFileBytes) {
      throw cannot_read(path, "it is larger than 1 GiB", "split the scene");
    }
  }
  if (std::ferror(file)) throw cannot_read(path, std::strerror(errno), "");
  return text;
}

std::string read_text_file(const std::string& path) {
  std::string text = read_file_bytes(path);
  refuse_binary(text, path);
  return text;
}

OutputFile::OutputFile(std::string path, bool force, Unfinished unfinished)
    : path_(std::move(path)), force_(force), unfinished_(unfinished) {
  const std::string open = path_ == "-" ? "1" : open_file(path_);
  if (open == "1") {
    stream_ = stdout;
    path_ = "standard output";
    open_temporary();
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) {
    throw InputError(path_, "", "cannot be written: it is a directory", "give a file name");
  }
  const bool exists = fs::exists(status);
  const bool direct = exists && (!fs::is_regular_file(status) || !open.empty());
  if (exists && !direct && !force_) refuse_existing(path_);
  if (!exists && !force_ && fs::is_symlink(fs::symlink_status(path_, error))) {
    throw InputError(path_, "",
                     "cannot be written: it is a symbolic link to a file that is missing",
                     "give another name, or --force to replace the link");
  }
  if (direct && !is_open_for(open, O_RDONLY)) fail(std::strerror(EBADF));
  target_ = path_;
  if (exists && !direct) {
    // What a link leads to is replaced, and the link stays.
    if (fs::is_symlink(fs::symlink_status(path_, error)))
      target_ = fs::canonical(path_, error).string();
    permissions_ = static_cast<unsigned>(status.permissions());
  }
  if (!direct) leftovers_ = partial_files(target_);
  if (!direct || fs::is_character_file(status)) {
    if (direct) {
      file_ = std::fopen(path_.c_str(), "wb");
      if (file_ == nullptr) fail(std::strerror(errno));
    } else {
      open_temporary();
    }
    return;
  }
  stream_ =
      fs::is_fifo(status) && open.empty() ? open_pipe(path_) : std::fopen(path_.c_str(), "wb");
  if (stream_ == nullptr) fail(std::strerror(errno));
  open_temporary();
}

// A file that was there before is never touched, whoever made it: numbers of processes come again.
void OutputFile::open_temporary() {
  if (stream_ != nullptr) {
    file_ = std::tmpfile();
  } else {
    const std::string name = target_ + ".partial-" + std::to_string(::getpid());
    int file = -1;
    for (int i = 0; file < 0; ++i) {
      temporary_ = i == 0 ? name : name + "-" + std::to_string(i);
      file = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file < 0 && errno != EEXIST) break;
    }
    if (file >= 0) file_ = ::fdopen(file, "wb");
    if (file < 0) temporary_.clear();
  }
  if (file_ == nullptr) fail(std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (stream_ != nullptr && stream_ != stdout) std::fclose(stream_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::fail(const char* what) {
  const std::string problem = std::string("cannot be written: ") + what;
  const std::string kept = unfinished_ == Unfinished::kLinesKept ? keep_lines() : "";
  if (!kept.empty()) {
    throw InputError(path_, "", problem + "; the lines that were written are in " + kept,
                     "make room, and run it again");
  }
  throw InputError(path_, "", problem,
                   stream_ != nullptr
                       ? "check the target of its redirection, and the room for temporary files"
                       : "give a name in a folder that exists and can be written");
}

void OutputFile::copy_to_stream(std::size_t bytes) {
  unfinished_ = Unfinished::kRemoved;  // fail() copies nothing again
  std::rewind(file_);
  char buffer[1 << 16];
  for (std::size_t left = bytes; left > 0;) {
    const std::size_t got = std::fread(buffer, 1, std::min(left, sizeof buffer), file_);
    if (got == 0 || std::fwrite(buffer, 1, got, stream_) != got) fail(std::strerror(errno));
    left -= got;
  }
  if (std::fflush(stream_) != 0) fail(std::strerror(errno));
}

std::string OutputFile::keep_lines() {
  if (stream_ != nullptr) {
    if (file_ == nullptr || std::fflush(file_) != 0) return "";
    const std::size_t bytes = end_of_last_line(file_);
    copy_to_stream(bytes);
    return "";
  }
  if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
  if (temporary_.empty() || !cut_after_last_line(temporary_)) return "";
  std::string name = target_ + ".partial";
  if (::link(temporary_.c_str(), name.c_str()) == 0) {
    std::remove(temporary_.c_str());
  } else {
    name = temporary_;
  }
  temporary_.clear();
  return name;
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(std::strerror(errno));
}

void OutputFile::begin_again() {
  if (stream_ == nullptr && temporary_.empty()) return;
  if (std::fflush(file_) != 0 || ::ftruncate(::fileno(file_), 0) != 0) fail(std::strerror(errno));
  std::rewind(file_);
}

void OutputFile::commit() {
  if (stream_ != nullptr) {
    const long size = std::fflush(file_) == 0 ? std::ftell(file_) : -1;
    if (size < 0) fail(std::strerror(errno));
    copy_to_stream(static_cast<std::size_t>(size));
    return;
  }
  const bool flushed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (!flushed) fail(std::strerror(errno));
  if (temporary_.empty()) return;
  if (!force_) {
    // Unlike renaming, a hard link never replaces a file that has appeared meanwhile.
    if (::link(temporary_.c_str(), target_.c_str()) == 0)
      return;  // the destructor removes the other
    if (errno == EEXIST) {
      const std::string kept = unfinished_ == Unfinished::kLinesKept ? keep_lines() : "";
      if (kept.empty()) refuse_existing(path_);
      throw InputError(path_, "",
                       "has appeared meanwhile; what was to be written there is in " + kept,
                       "give that another name");
    }
  }
  if (permissions_) {
    std::error_code error;
    fs::permissions(temporary_, static_cast<fs::perms>(*permissions_),
                    error);  // as far as the file system has them
  }
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(std::strerror(errno));
  temporary_.clear();
}

}  // namespace kinex::formats
