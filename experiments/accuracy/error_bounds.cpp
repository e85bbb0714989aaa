#include "experiments/accuracy/experiments.h"

#include "verify/proofs/all_proofs.h"
#include "verify/proofs/gappa_script.h"
#include "verify/proofs/other_constants.h"
#include "verify/searches/searches.h"

#include <stdexcept>

namespace tetracone::experiments {

void run_error_bounds(const Experiment_options& options)
{
  constexpr int steps = 20000;
  if (!verify::proofs::gappa_is_there())
    throw std::runtime_error("gappa: not found; expected the Debian package gappa, which proves the bounds");
  Csv_table table;
  for (const auto& bound : verify::proofs::all_proofs()) {
    const double in_code = bound.in_code.get_d() / bound.unit, proved = bound.proved.get_d() / bound.unit;
    const double worst = verify::proofs::worst_found(bound.name, steps, unsigned(options.seed));
    const auto found = worst < 0 ? std::nullopt : std::optional(worst);
    Csv_row row;
    row.add("constant", bound.name).add("file", bound.file).add("unit", bound.unit).add("in_code", in_code);
    row.add("proved", proved).add("proved_by", bound.by).add("proof", bound.proof);
    std::printf("%-50s %9.4f in the code %9.4f proved", bound.name.c_str(), in_code, proved);
    if (found) std::printf(" %9.4f found, margin %.2f", *found, proved / *found);
    std::puts("");
    row.add("found", found).add("proved_over_found", found ? std::optional(proved / *found) : std::nullopt);
    row.add("not_searched", verify::proofs::why_not_searched(bound.name));
    table.add(row.add_origin(options.seed));
  }
  for (const auto& [file, name, kind, reason] : verify::proofs::other_constants()) {
    using verify::proofs::Constant_kind;
    if (kind != Constant_kind::tested && kind != Constant_kind::by_hand) continue;
    const bool is_tested = kind == Constant_kind::tested;
    Csv_row row;
    row.add("constant", name).add("file", file).none("unit").none("in_code").none("proved");
    row.add("proved_by", is_tested ? "test" : "hand").add("proof", is_tested ? reason : file);
    row.none("found").none("proved_over_found").add("not_searched", is_tested ? "" : reason);
    table.add(row.add_origin(options.seed));
  }
  write_whole(options.out / "error_bounds.csv", table.text());
}

}  // namespace tetracone::experiments
