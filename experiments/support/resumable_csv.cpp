#include "experiments/support/resumable_csv.h"

#include "experiments/support/build_info.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/text_lines.h"

#include <cctype>
#include <string_view>

namespace tetracone::experiments {
namespace {

/// Returns the options of the command line as a folder's name: `race-frames-60-seed-1`.
std::string folder_of_words()
{
  constexpr std::string_view out = " --out out";  // the last word that is the same whatever the sizes are
  const std::size_t at = again().find(out);
  std::string name = at == std::string::npos ? again() : again().substr(at + out.size());
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '.'; }, '-');
  const auto doubled = std::ranges::unique(name, [](char a, char b) { return a == '-' && b == '-'; });
  name.erase(doubled.begin(), doubled.end());
  return name;
}

}  // namespace

void write_table(const std::filesystem::path& out, const std::string& name, const std::vector<Table_part>& parts)
{
  const std::filesystem::path folder = out / name / ("v" TETRACONE_VERSION + folder_of_words());
  make_folder(folder);

  std::string table;
  Progress progress(name, parts.size());
  for (const Table_part& part : parts) {
    const std::filesystem::path file = folder / (part.name + ".csv");
    if (!std::filesystem::exists(file)) write_whole(file, part.make());
    const std::string rows = covering::read_bytes(file);
    table += table.empty() ? rows : rows.substr(rows.find('\n') + 1);
    progress.step();
  }
  write_whole(out / (name + ".csv"), table);
}

}  // namespace tetracone::experiments
