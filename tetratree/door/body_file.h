#ifndef TETRACONE_TETRATREE_DOOR_BODY_FILE_H
#define TETRACONE_TETRATREE_DOOR_BODY_FILE_H

#include <cstddef>
#include <filesystem>
#include <memory>

namespace tetracone::detail {

struct Body_data;

/// True when the name ends in .body, in any case of letters.
bool is_body_file(const std::filesystem::path& file);

/// The byte of a saved body at which its checksum begins. The checksum is of the file with 0 in its place.
inline constexpr std::size_t place_of_checksum = 136;

/// Writes the body and its fast tree. Requires that all nodes are made. Throws Error as `save_body`.
///
/// The file is a header of fixed size and arrays, each at a multiple of 64 bytes. The nodes begin at the first byte of
/// a page, to be used in place. The header holds the version of the format, the machine's order of bytes, and a
/// checksum of the file. It also holds the element size and the count of each array. The arrays are the vertices, the
/// loops, the faces' triangles, the order of the tree's elements and its nodes. Nothing is written that can be derived
/// from these.
void write_body_file(const Body_data& body, const std::filesystem::path& file);

/// Returns a saved body. Nothing in the file is trusted. Vertices, faces and triangles are checked as `Body` checks
/// them, the order must be a permutation, and `tree_flaw` checks the nodes. Throws Error as `read_body`.
///
/// Its cost is given as a fraction of the time of building the body (torus of 70,000 triangles, one thread):
/// - the checksum: 1/20;
/// - everything that is derived anew: 1/14;
/// - the check of the nodes: 1/8.
/// The total is 1/3, including the allocation of memory.
std::shared_ptr<const Body_data> read_body_file(const std::filesystem::path& file);

}  // namespace tetracone::detail

#endif
