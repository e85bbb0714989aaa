#ifndef TETRACONE_EXPERIMENTS_QUERIES_TOUCHING_H
#define TETRACONE_EXPERIMENTS_QUERIES_TOUCHING_H

#include <cstdint>
#include <string>

namespace tetracone::experiments {

/// Returns the answers of the peers about boxes that touch or overlap: a CSV with a row per kind of pair, frame and
/// peer. A row counts the pairs, and those that collide by the peer's answer. A peer that does not take such bodies has
/// no row. The exact relation of each pair is known by its kind; `wrong_relations` counts those for which ours differs.
/// Each kind has `cases` pairs in the axes' frame, and as many in frames that are turned.
///
/// Coordinates are quarters, and the entries of a turned frame are multiples of 2^-40. So the poses of both boxes are
/// doubles that place them exactly, within 1e-11 of a rotation.
std::string touching_csv(int cases, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
