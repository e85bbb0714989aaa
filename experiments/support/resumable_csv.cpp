#include "experiments/support/resumable_csv.h"

#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/text_lines.h"

namespace tetracone::experiments {

void write_table(const std::filesystem::path& out, const std::string& name, const std::string& key,
                 const std::vector<Table_part>& parts)
{
  const std::filesystem::path folder = out / name / ("v" TETRACONE_VERSION "-" + key);
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
