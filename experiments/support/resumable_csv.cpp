#include "experiments/support/resumable_csv.h"

#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/text_lines.h"

#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace tetracone::experiments {

void write_table(const std::filesystem::path& out, const std::string& name, const std::string& key, const std::vector<Table_part>& parts)
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

void draw_table(const std::string& script, const std::filesystem::path& out)
{
  if (out.native().find('\'') != std::string::npos) throw std::runtime_error("the folder's name holds a quote; expected one without");
  const std::string command = "/usr/bin/python3 '" TETRACONE_SOURCE_DIR "/experiments/report/" + script + "' '" + out.native() + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("the figures could not be drawn; expected python3 with matplotlib");
}

}  // namespace tetracone::experiments
