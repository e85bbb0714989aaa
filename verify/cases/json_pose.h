#ifndef TETRACONE_VERIFY_CASES_JSON_POSE_H
#define TETRACONE_VERIFY_CASES_JSON_POSE_H

#include "tetracone/kernel/number/pose.h"
#include "verify/cases/json_field.h"

namespace tetracone::verify {

/// Returns a pose of three rows of four numbers. Throws covering::Input_error for anything else, and for det M = 0.
kernel::Pose pose_of_rows(const Json_field& field);

/// Returns a pose of twelve numbers, row after row. Throws as `pose_of_rows`.
kernel::Pose pose_of_numbers(const Json_field& field);

}  // namespace tetracone::verify

#endif
