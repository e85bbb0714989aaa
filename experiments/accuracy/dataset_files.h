#ifndef TETRACONE_EXPERIMENTS_ACCURACY_DATASET_FILES_H
#define TETRACONE_EXPERIMENTS_ACCURACY_DATASET_FILES_H

#include <string_view>

/// The files of experiments/accuracy/dataset/, which `export_dataset` writes beside the cases. CMake writes their
/// definitions (experiments/CMakeLists.txt).
namespace tetracone::experiments::dataset_files {

extern const std::string_view readme_md, license, tetracone_dataset_py, score_py, example_py, croissant_json;

/// The date of this version, from CITATION.cff.
extern const std::string_view date_released;

}  // namespace tetracone::experiments::dataset_files

#endif
