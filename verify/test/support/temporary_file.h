#ifndef TETRACONE_VERIFY_TEST_SUPPORT_TEMPORARY_FILE_H
#define TETRACONE_VERIFY_TEST_SUPPORT_TEMPORARY_FILE_H

#include "tetracone/covering/io/input_error.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tetracone::verify {

/// Returns a path for this process in the system's folder for temporary files. Equal names give one path.
inline std::filesystem::path temporary_path(const std::string& name)
{
  return std::filesystem::temp_directory_path() / ("tetracone_" + std::to_string(::getpid()) + "_" + name);
}

/// A file at such a path with these bytes. Its destructor removes it.
class Temporary_file {
 public:
  Temporary_file(const std::string& name, const std::string& bytes) : path_(temporary_path(name))
  {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~Temporary_file() { std::filesystem::remove(path_); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A temporary folder, which is not made yet. Its destructor removes it with all that it contains.
class Temporary_folder {
 public:
  explicit Temporary_folder(const std::string& name) : path_(temporary_path(name))
  {
    std::filesystem::remove_all(path_);
  }
  ~Temporary_folder() { std::filesystem::remove_all(path_); }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Returns the message of the input error that read(path) throws, without the file's path: ":4: what is wrong; what was
/// expected". Returns "no error" when it throws none.
template <class Read>
std::string error_of(const Temporary_file& file, const Read& read)
{
  try {
    read(file.path());
  } catch (const covering::Input_error& error) {
    const std::string message = error.what(), path = file.path().native();
    return message.starts_with(path) && message.find('\n') == std::string::npos ? message.substr(path.size())
                                                                                : "no clear line: " + message;
  }
  return "no error";
}

/// Returns the same for a file with this text.
template <class Read>
std::string error_of(const std::string& text, const Read& read)
{
  return error_of(Temporary_file("read.txt", text), read);
}

}  // namespace tetracone::verify

#endif
