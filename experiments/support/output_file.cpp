#include "experiments/support/output_file.h"

#include "tetracone/covering/io/input_error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <string_view>
#include <system_error>

namespace tetracone::experiments {
namespace {

namespace fs = std::filesystem;

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_all(int descriptor, std::string_view text)
{
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return last_error();
    if (written > 0) text.remove_prefix(std::size_t(written));
  }
  return {};
}

/// Opens the file with these flags, writes and closes it.
std::error_code write_to(const fs::path& file, int flags, std::string_view text)
{
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) return last_error();
  const std::error_code error = write_all(descriptor, text);
  if (::close(descriptor) != 0 && !error) return last_error();
  return error;
}

/// Returns the file to which a link leads, even if nothing exists there yet.
fs::path followed(fs::path file)
{
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(file, error)); ++links)
    file = file.parent_path() / fs::read_symlink(file, error);
  return file;
}

/// Replaces the file by way of a temporary one, which is removed if that fails.
std::error_code replace(const fs::path& file, std::string_view text)
{
  // A rename does not check the permissions of the file itself.
  if (::access(file.c_str(), W_OK) != 0 && errno != ENOENT) return last_error();
  const fs::path temporary = file.native() + ".part" + std::to_string(getpid());
  std::error_code error = write_to(temporary, O_CREAT | O_TRUNC, text), ignored;
  if (!error) fs::rename(temporary, file, error);
  if (error) fs::remove(temporary, ignored);
  return error;
}

std::error_code write_somehow(const fs::path& file, std::string_view text)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::none) return error;
  if (!fs::exists(status)) return replace(followed(file), text);
  // After a rename, the shell would go on writing to another file.
  if (fs::equivalent(file, "/proc/self/fd/1", error)) return write_all(STDOUT_FILENO, text);
  return fs::is_regular_file(status) ? replace(followed(file), text) : write_to(file, 0, text);
}

[[noreturn]] void refuse(const fs::path& file, const std::string& what, const std::error_code& why,
                         const char* expected)
{
  throw covering::Input_error(file.native(), 0, what + (why ? ": " + why.message() : ""), expected);
}

}  // namespace

void make_folder(const fs::path& folder)
{
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, ignored))
    refuse(folder, "cannot be made", error, "expected a folder that may be written");
}

void write_whole(const fs::path& file, const std::string& text)
{
  if (const std::error_code error = write_somehow(file, text))
    refuse(file, "cannot be written", error, "expected a file in a folder that may be written");
}

void write_answers(const std::string& csv, const std::string& text)
{
  if (csv.empty())
    std::cout << text;
  else
    write_whole(csv, text);
}

void refuse_input(const fs::path& output, const std::vector<fs::path>& inputs)
{
  std::error_code none;
  for (const fs::path& input : inputs)
    if (fs::equivalent(output, input, none))
      refuse(output, "is an input too: " + input.native(), {}, "expected another file for the results");
}

bool is_same_file(const fs::path& a, const fs::path& b)
{
  // weakly_canonical leaves a relative name unchanged if no part of it exists.
  std::error_code none;
  const fs::path of_a = fs::weakly_canonical(fs::absolute(a, none), none);
  return !of_a.empty() && of_a == fs::weakly_canonical(fs::absolute(b, none), none);
}

}  // namespace tetracone::experiments
