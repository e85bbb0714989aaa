#ifndef TETRACONE_COVERING_IO_MAPPED_FILE_H
#define TETRACONE_COVERING_IO_MAPPED_FILE_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace tetracone::covering {

/// The bytes of a file, mapped read-only where the system keeps them. They are valid as long as nobody makes the file
/// shorter.
class Mapped_file {
 public:
  /// Maps the file. Throws Input_error as `read_bytes`, and for a pipe.
  explicit Mapped_file(const std::filesystem::path& file)
  {
    const auto fail = [&](const char* wrong, const char* expected) {
      throw Input_error(file.native(), 0, wrong, expected);
    };
    if (!std::filesystem::is_regular_file(status_to_read(file))) fail("is a pipe", "expected a file");
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) fail("cannot be opened", "expected a file that may be read");
    struct ::stat status;
    void* pages = MAP_FAILED;
    if (::fstat(descriptor, &status) == 0) {
      size_ = std::size_t(status.st_size);
      pages = size_ == 0 ? nullptr : ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
    }
    ::close(descriptor);
    if (pages == MAP_FAILED) fail("cannot be mapped", "expected a file that may be read");
    pages_ = static_cast<std::byte*>(pages);
  }
  ~Mapped_file()
  {
    if (pages_ != nullptr) ::munmap(pages_, size_);
  }
  Mapped_file(const Mapped_file&) = delete;

  std::string_view bytes() const { return {reinterpret_cast<const char*>(pages_), size_}; }

  /// Gives away the pages from byte `at` on, first of a page, before the end. The taker unmaps them, and must not
  /// write. `bytes` is empty afterwards.
  void* release_from(std::size_t at)
  {
    assert(at < size_);
    if (at > 0) ::munmap(pages_, at);
    void* const released = pages_ + at;
    pages_ = nullptr;
    size_ = 0;
    return released;
  }

 private:
  std::byte* pages_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace tetracone::covering

#endif
