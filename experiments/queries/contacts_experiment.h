#ifndef TETRACONE_EXPERIMENTS_QUERIES_CONTACTS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_CONTACTS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// How fast are all contacts of two bodies of 7172 triangles that collide, and how many of FCL's are wrong? The poses
/// of contour and circular trajectories in which surfaces meet, asked in turn, the fastest time of each. `frames`: poses
/// of each trajectory, those apart included; `models` is the folder that fetch_models.sh filled. Writes out/contacts.csv, a row a method and trajectory, and prints it.
void run_contacts(const std::filesystem::path& out, const std::filesystem::path& models, int frames,
                  std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
