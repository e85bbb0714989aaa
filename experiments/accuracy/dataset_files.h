#ifndef TETRACONE_EXPERIMENTS_ACCURACY_DATASET_FILES_H
#define TETRACONE_EXPERIMENTS_ACCURACY_DATASET_FILES_H

#include <string_view>

/// The texts of the files of experiments/accuracy/dataset/, which `export_dataset` writes beside the cases. A name is
/// the file's in lower case, with _ for the dot. `readme_md` is a beginning, to which `export_dataset` adds fields and
/// families. In `croissant_json` it fills in version, date, sizes, checksums and fields. CMake writes the definitions
/// (experiments/CMakeLists.txt).
namespace tetracone::experiments::dataset_files {

extern const std::string_view readme_md, license, tetracone_dataset_py, score_py, example_py, croissant_json;

/// The date of this version, YYYY-MM-DD, from CITATION.cff.
extern const std::string_view date_released;

}  // namespace tetracone::experiments::dataset_files

#endif
