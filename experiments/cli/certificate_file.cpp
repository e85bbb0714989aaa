#include "experiments/cli/certificate_file.h"

#include "experiments/support/output_file.h"
#include "experiments/support/sha256.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/io/text_lines.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace tetracone::experiments {
namespace {

void name_file(Certificate& certificate, std::size_t body, const Model_file& model)
{
  const std::filesystem::path path = model.file;
  const std::string suffix = covering::suffix_of(path);
  if (!model.is_as_in_file || (suffix != ".off" && suffix != ".obj" && suffix != ".poly")) return;
  std::string bytes = covering::read_bytes(path);
  // TetGen's vertices may be in a file of their own: the first word of the file is then 0.
  covering::Text_lines lines(model.file, bytes, '#');
  if (suffix == ".poly" && lines.next() && covering::parse_count(lines.words()[0]) == 0)
    bytes += covering::read_bytes(std::filesystem::path(path).replace_extension(".node"));
  certificate.name_file(body, {path.filename().native(), sha256(bytes), model.source_face});
}

}  // namespace

void add_certificate_option(CLI::App& command, std::string& file)
{
  command.add_option(
      "--certificate", file,
      "Write to this file why the answers are right: JSON that experiments/certificates/check.py proves");
}

void require_other_file(const std::string& certificate, const std::string& csv)
{
  if (!csv.empty() && !certificate.empty() && is_same_file(csv, certificate))
    throw CLI::ValidationError("--certificate", "expected another file than --csv");
}

void write_certificate(const std::string& file, const Certificate& certificate)
{
  write_whole(file, certificate.text());
  if (certificate.without_proof() > 0)
    std::cerr << file << ": without a proof, and left out: " << certificate.without_proof() << " answers\n";
}

Certificate certificate_of(const Model_file& model)
{
  Certificate certificate(model.body);
  name_file(certificate, 0, model);
  return certificate;
}

Certificate certificate_of(const Model_file& a, const Model_file& b)
{
  Certificate certificate(a.body, b.body);
  name_file(certificate, 0, a);
  name_file(certificate, 1, b);
  return certificate;
}

}  // namespace tetracone::experiments
