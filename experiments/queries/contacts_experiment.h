#ifndef TETRACONE_EXPERIMENTS_QUERIES_CONTACTS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_CONTACTS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures how fast all contacts of two colliding bodies of 7172 triangles are found, and how many of FCL's are wrong.
/// It asks in turn the poses of contour and circular trajectories in which surfaces meet, and keeps the fastest time of
/// each. `frames` counts the poses of each trajectory, including those in which the bodies are apart. `models` is the
/// folder that fetch_models.sh filled. Writes out/contacts.csv, one row per method and trajectory, and prints it.
void run_contacts(const std::filesystem::path& out, const std::filesystem::path& models, int frames,
                  std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
