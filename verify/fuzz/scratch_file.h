#ifndef TETRACONE_VERIFY_FUZZ_SCRATCH_FILE_H
#define TETRACONE_VERIFY_FUZZ_SCRATCH_FILE_H

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

namespace tetracone::verify {

/// A file of this process for readers that need a path; it is in memory if /dev/shm exists. The destructor removes it.
/// Two objects of one process with equal suffixes have one file.
class Scratch_file {
 public:
  explicit Scratch_file(const std::string& suffix)
      : path_((std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm")
                                                   : std::filesystem::temp_directory_path()) /
              ("tetracone_fuzz_" + std::to_string(::getpid()) + suffix))
  {}
  ~Scratch_file()
  {
    std::error_code error;
    std::filesystem::remove(path_, error);
  }
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes the bytes. Requires a folder that can be written.
  void write(const std::uint8_t* data, std::size_t size) const
  {
    std::FILE* file = std::fopen(path_.c_str(), "wb");
    std::fwrite(data, 1, size, file);
    std::fclose(file);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace tetracone::verify

#endif
