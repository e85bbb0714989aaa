#ifndef TETRACONE_VERIFY_TEST_TEMPORARY_FILE_H
#define TETRACONE_VERIFY_TEST_TEMPORARY_FILE_H

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tetracone::verify {

/// A file in the system's folder for temporary files, with these bytes; removed with this object.
class Temporary_file {
 public:
  Temporary_file(const std::string& name, const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() / ("tetracone_" + std::to_string(::getpid()) + "_" + name))
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

}  // namespace tetracone::verify

#endif
