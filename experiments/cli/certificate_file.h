#ifndef TETRACONE_EXPERIMENTS_CLI_CERTIFICATE_FILE_H
#define TETRACONE_EXPERIMENTS_CLI_CERTIFICATE_FILE_H

#include "experiments/support/model_file.h"
#include "tetracone/tetratree/door/certificate.h"

#include <cstddef>

namespace CLI {
class App;
}

namespace tetracone::experiments {

/// Adds the option --certificate FILE.
void add_certificate_option(CLI::App& command, std::string& file);

/// Throws CLI::ValidationError if both names lead to one file; an empty name leads to none.
void require_other_file(const std::string& certificate, const std::string& csv);

/// Writes the certificate. A line on stderr says how many answers have no proof, if some have none. Throws
/// covering::Input_error when the file cannot be written.
void write_certificate(const std::string& file, const Certificate& certificate);

/// Returns an empty certificate about the model, or about both. A model is named by its file and hash if it is as in
/// its file, and the format is one that experiments/certificates/check.py reads: OFF, OBJ or .poly. Another model is
/// written into the certificate. Throws covering::Input_error when a file that is named cannot be read again.
Certificate certificate_of(const Model_file& model);
Certificate certificate_of(const Model_file& a, const Model_file& b);

}  // namespace tetracone::experiments

#endif
