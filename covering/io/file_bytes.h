#ifndef TETRACONE_COVERING_IO_FILE_BYTES_H
#define TETRACONE_COVERING_IO_FILE_BYTES_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/mapped_file.h"
#include "tetracone/covering/io/text_lines.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetracone::covering {

/// All bytes of a file: mapped where the system can, else copied (from a pipe, for example). A file that is made
/// shorter while it is mapped ends the process by SIGBUS.
class File_bytes {
 public:
  /// Maps or reads the file. Throws Input_error as `read_bytes`.
  explicit File_bytes(const std::filesystem::path& file)
  {
    if (std::filesystem::is_regular_file(status_to_read(file))) map(file);
    // The system reports no size for some files, such as those in /proc.
    if (bytes().empty()) copied_ = read_bytes(file);
  }

  std::string_view bytes() const { return mapped_ ? mapped_->bytes() : std::string_view(copied_); }

 private:
  void map(const std::filesystem::path& file)
  {
    try {
      mapped_.emplace(file);
    } catch (const Input_error&) {  // reading it succeeds, or throws the reason
    }
    if (mapped_ && mapped_->bytes().empty()) mapped_.reset();
  }

  std::optional<Mapped_file> mapped_;
  std::string copied_;
};

}  // namespace tetracone::covering

#endif
