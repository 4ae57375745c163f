// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/file_io.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "experiments/input_error.h"

namespace kinex {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

InputError cannot_read(const std::string& path, const std::string& why, const char* remedy) {
  return InputError(path, "", "cannot be read: " + why, remedy);
}

void refuse_existing(const std::string& path) {
  throw InputError(path, "", "exists already", "give another name, or --force to replace it");
}

}  // namespace

std::string read_text_file(const std::string& path) {
  const bool standard_input = path == "-";
  std::error_code error;
  if (!standard_input && fs::is_directory(path, error)) {
    throw cannot_read(path, "it is a directory", "give a file");
  }
  std::unique_ptr<std::FILE, CloseFile> owned;
  if (!standard_input) {
    owned.reset(std::fopen(path.c_str(), "rb"));
    if (!owned) throw cannot_read(path, std::strerror(errno), "check the name and its permissions");
  }
  std::FILE* file = standard_input ? stdin : owned.get();
  std::string text;
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

OutputFile::OutputFile(std::string path, bool force) : path_(std::move(path)), force_(force) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) {
    throw InputError(path_, "", "cannot be written: it is a directory", "give a file name");
  }
  const bool exists = fs::exists(status);
  const bool direct = exists && !fs::is_regular_file(status);
  if (exists && !direct && !force_) refuse_existing(path_);
  if (!direct) temporary_ = path_ + ".partial-" + std::to_string(::getpid());
  file_ = std::fopen((direct ? path_ : temporary_).c_str(), "wb");
  if (file_ == nullptr) fail(std::strerror(errno));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::fail(const char* what) const {
  throw InputError(path_, "", std::string("cannot be written: ") + what,
                   "give a name in a folder that exists and can be written");
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(std::strerror(errno));
}

void OutputFile::commit() {
  const bool flushed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (!flushed) fail(std::strerror(errno));
  if (temporary_.empty()) return;
  if (!force_) {
    // A hard link, unlike a renaming, never replaces what has appeared meanwhile.
    if (::link(temporary_.c_str(), path_.c_str()) == 0) return;  // the destructor removes the other
    if (errno == EEXIST) refuse_existing(path_);
  }
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(std::strerror(errno));
  temporary_.clear();
}

}  // namespace kinex
