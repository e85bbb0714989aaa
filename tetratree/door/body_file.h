#ifndef TETRACONE_TETRATREE_DOOR_BODY_FILE_H
#define TETRACONE_TETRATREE_DOOR_BODY_FILE_H

#include <filesystem>
#include <memory>

namespace tetracone::detail {

struct Body_data;

/// Whether the name ends in .body, in any case of letters.
bool is_body_file(const std::filesystem::path& file);

/// Writes the body and its fast tree: a header of fixed size, the arrays that they are made of, each from a multiple of
/// 64 bytes on, and from the first byte of a page on the nodes, to be used where they are. The header says the version
/// of the format, the machine's order of bytes, of each array its elements' size and count, and a checksum of all the
/// file. Requires that all nodes are made. Throws Error as `save_body`.
void write_body_file(const Body_data& body, const std::filesystem::path& file);

/// Throws Error as `read_body`.
std::shared_ptr<const Body_data> read_body_file(const std::filesystem::path& file);

}  // namespace tetracone::detail

#endif
